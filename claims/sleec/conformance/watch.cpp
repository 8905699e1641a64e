// SPDX-License-Identifier: Apache-2.0
// See watch.hpp. docs/rules-language.md, "Whether a model obeys".
#include "claims/sleec/conformance/watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "checker/cspm/syntax/build.hpp"
#include "claims/sleec/obligations/open.hpp"

namespace robochart::sleec {
namespace {

namespace build = cspm::build;
using build::Exprs;
using cspm::DeclPtr;
using cspm::ExprKind;
using Tree = cspm::ExprPtr;

constexpr const char* broken_event = "sleec_broken";
constexpr const char* asked_event = "sleec_asked";
constexpr const char* free_process = "sleec_Free";
constexpr const char* idle_process = "sleec_Idle";
constexpr const char* wrong_process = "sleec_Wrong";
constexpr const char* all_events = "sleec_events";
constexpr std::size_t most_ways = 4096;

/// Special values of a measure at an instant, in addition to its classes.
constexpr std::int64_t unknown = -1;
constexpr std::int64_t changing = -2;

Tree time_variable() {
    return build::name("t");
}

Tree at_most(std::int64_t second) {
    return build::binary(ExprKind::less_equal, time_variable(), build::number(second));
}

/// True if the second is in the demand's window.
Tree within_window(const Demand& demand) {
    Exprs conditions;
    if (demand.begin > 0)
        conditions.push_back(build::binary(ExprKind::greater_equal, time_variable(), build::number(demand.begin)));
    if (demand.end != forever) conditions.push_back(at_most(demand.end));
    return build::all_of(std::move(conditions));
}

/// True if a demand for an event can still be fulfilled.
Tree can_still_be_met(const Obligation& obligation) {
    Exprs conditions;
    for (const Demand& demand : obligation.any) {
        if (demand.forbids) continue;
        if (demand.end == forever) return build::boolean(true);
        conditions.push_back(at_most(demand.end));
    }
    return build::any_of(std::move(conditions));
}

bool waits_forever(const Obligation& obligation) {
    return std::ranges::any_of(obligation.any,
                               [](const Demand& demand) { return !demand.forbids && demand.end == forever; });
}

const Demand* find_prohibition(const Obligation& obligation) {
    for (const Demand& demand : obligation.any)
        if (demand.forbids) return &demand;
    return nullptr;
}

/// Returns the second after which only windows without end are open.
std::int64_t last_second(const Obligation& obligation) {
    std::int64_t last = 0;
    for (const Demand& demand : obligation.any)
        last = std::max(last, demand.end == forever ? demand.begin : demand.end + 1);
    return last;
}

std::string open_process(std::size_t obligation, bool broken) {
    return fmt::format("sleec_Open{}{}", obligation, broken ? "b" : "");
}

std::string class_variable(std::size_t place) {
    return fmt::format("k{}", place);
}

Tree break_process() {
    return build::prefix(build::name(broken_event), build::stop());
}

}  // namespace

Watch::Watch(const CheckedRules& rules, std::size_t rule, const Linking& linking, cspm::ExprPtr process,
             Readings readings)
    : rules_(rules), rule_(rule), linking_(linking), process_(std::move(process)), readings_(readings) {
    find_classes();
    find_ways();
}

std::optional<std::size_t> Watch::way_of(const std::string& event) {
    const std::string prefix = std::string(asked_event) + ".";
    if (!event.starts_with(prefix)) return std::nullopt;
    std::size_t way = 0;
    const auto [end, error] = std::from_chars(event.data() + prefix.size(), event.data() + event.size(), way);
    return error == std::errc() ? std::optional(way) : std::nullopt;
}

// ---------------------------------------------------------------- values

/// Finds the classes of a number: below, at and between the constants with which it is compared. The rule does not
/// distinguish values of one class.
void Watch::find_classes() {
    const CheckedRule& rule = rules_.rules[rule_];
    const auto values = representative_values(rules_, {rule_});
    if (compares_measures(rule)) throw NotDecided("a condition compares two measures of the model");
    for (const std::size_t measure : measures_of(rule)) {
        Followed followed;
        followed.measure = measure;
        if (rules_.measure(measure).type != MeasureType::numeric) {
            followed.representatives = followed.classes = values[measure];
            followed_.push_back(std::move(followed));
            continue;
        }
        followed.constants = constants_of(rule, measure);
        for (std::size_t i = 0; i <= followed.constants.size(); ++i) {
            const bool first = i == 0, last = i == followed.constants.size();
            std::int64_t between = 0;
            if (!first)
                between = followed.constants[i - 1] + 1;
            else if (!last)
                between = followed.constants[0] - 1;
            if (first || last || between < followed.constants[i]) {
                followed.classes.push_back(static_cast<std::int64_t>(2 * i));
                followed.representatives.push_back(between);
            }
            if (last) continue;
            followed.classes.push_back(static_cast<std::int64_t>(2 * i + 1));
            followed.representatives.push_back(followed.constants[i]);
        }
        followed_.push_back(std::move(followed));
    }
}

Tree Watch::class_of(const Followed& followed, const Tree& value) const {
    const Measure& measure = rules_.measure(followed.measure);
    if (measure.type == MeasureType::boolean) return build::if_(value, build::number(1), build::number(0));
    Tree result;
    if (measure.type == MeasureType::scale) {
        const auto& literals = linking_.measures[followed.measure]->literals;
        result = build::number(static_cast<std::int64_t>(literals.size()) - 1);
        for (std::size_t i = literals.size() - 1; i > 0; --i)
            result = build::if_(build::binary(ExprKind::equal, value, build::name(literals[i - 1])),
                                build::number(static_cast<std::int64_t>(i) - 1), result);
        return result;
    }
    result = build::number(static_cast<std::int64_t>(2 * followed.constants.size()));
    for (std::size_t i = followed.constants.size(); i > 0; --i) {
        const Tree constant = build::number(followed.constants[i - 1]);
        const auto place = static_cast<std::int64_t>(2 * i);
        result = build::if_(build::binary(ExprKind::equal, value, constant), build::number(place - 1), result);
        result = build::if_(build::binary(ExprKind::less, value, constant), build::number(place - 2), result);
    }
    return result;
}

std::size_t Watch::number_obligation(const Obligation& obligation) {
    const auto found = std::ranges::find(obligations_, obligation);
    if (found != obligations_.end()) return static_cast<std::size_t>(found - obligations_.begin());
    if (std::ranges::count_if(obligation.any, [](const Demand& demand) { return demand.forbids; }) > 1)
        throw NotDecided("a rule with several prohibitions behind each other");
    obligations_.push_back(obligation);
    return obligations_.size() - 1;
}

/// Lists all combinations of classes, in the order in which the script tests them.
void Watch::find_ways() {
    std::vector<std::size_t> at(followed_.size(), 0);
    for (;;) {
        Valuation values(rules_.measures.size(), 0);
        for (std::size_t i = 0; i < at.size(); ++i) values[followed_[i].measure] = followed_[i].representatives[at[i]];
        const auto obligation = obligation_of(rules_.rules[rule_], values, WithoutLimit::eventually);
        ways_.push_back({values, obligation ? number_obligation(*obligation) : obligations_.max_size()});
        if (ways_.size() > most_ways)
            throw NotDecided(fmt::format("the measures have more than {} combinations of values", most_ways));
        std::size_t i = at.size();
        while (i > 0 && ++at[i - 1] == followed_[i - 1].classes.size()) at[--i] = 0;
        if (i == 0) return;
    }
}

// ---------------------------------------------------------------- processes

std::vector<std::size_t> Watch::event_indices() const {
    const EventCases& trigger = rules_.rules[rule_].trigger;
    std::set<std::size_t> events(trigger.begin(), trigger.end());
    for (const Obligation& obligation : obligations_) {
        for (const Demand& demand : obligation.any) events.insert(demand.event.begin(), demand.event.end());
        events.insert(obligation.ended_by.begin(), obligation.ended_by.end());
    }
    return {events.begin(), events.end()};
}

Tree Watch::named_events() const {
    Exprs items;
    for (const std::size_t event : event_indices())
        for (const Tree& prefix : linking_.events[event].value().prefixes) items.push_back(prefix);
    for (std::size_t i = 0; i < followed_.size(); ++i)
        if (const LinkedMeasure* linked = channel_of(i)) items.push_back(build::name(linked->channel));
    for (const std::string& channel : state_channels()) items.push_back(build::name(channel));
    items.push_back(build::name("tock"));
    return build::productions(std::move(items));
}

/// Returns the channel from which the component reads a measure; null for a state, and for a measure that the component
/// does not have.
const LinkedMeasure* Watch::channel_of(std::size_t place) const {
    const auto& linked = linking_.measures[followed_[place].measure];
    return linked && linked->facts == 0 ? &*linked : nullptr;
}

/// Returns the channels by which machines show the states of the rule, without duplicates.
std::vector<std::string> Watch::state_channels() const {
    std::vector<std::string> result;
    for (const Followed& followed : followed_) {
        const auto& linked = linking_.measures[followed.measure];
        if (linked && linked->facts > 0 && std::ranges::find(result, linked->channel) == result.end())
            result.push_back(linked->channel);
    }
    return result;
}

/// Receives the facts that a machine shows, and continues as `process`. `first` is the index of the argument for the
/// first measure. If `follow` is true, the arguments for the states of this machine are set to the shown facts.
Tree Watch::show_states(const std::string& channel, const std::string& process, Exprs arguments, std::size_t first,
                        bool follow) const {
    std::vector<cspm::Field> fields;
    for (std::size_t i = 0; i < followed_.size(); ++i) {
        const auto& linked = linking_.measures[followed_[i].measure];
        if (!linked || linked->facts == 0 || linked->channel != channel) continue;
        const std::string shown = fmt::format("s{}", linked->shown);
        if (follow) arguments[first + i] = class_of(followed_[i], build::name(shown));
        for (std::size_t k = fields.size(); k < linked->facts; ++k)
            fields.push_back(build::input(fmt::format("s{}", k)));
    }
    return build::prefix(build::name(channel), std::move(fields), build::call(process, std::move(arguments)));
}

/// Returns a process that performs any of these events and then continues as `then`.
Tree Watch::any_event(const EventCases& events, const Tree& then) const {
    Exprs prefixes;
    for (const std::size_t event : events)
        for (const Tree& prefix : linking_.events[event].value().prefixes) prefixes.push_back(prefix);
    if (prefixes.empty()) return build::stop();  // the instantiation contains none of the values that the rule names
    return build::replicated(ExprKind::replicated_external,
                             {build::generator("x", build::productions(std::move(prefixes)))},
                             build::prefix(build::name("x"), then));
}

/// Returns a call of the start process, which assumes a value for each measure that the component has not yet read at
/// this instant. If the component reads the measure later at this instant, and the value is not the assumed one, the
/// run is discarded. The measures before `from` are decided.
Tree Watch::start_call(std::size_t from, Valuation classes) const {
    if (from == followed_.size()) {
        std::size_t way = 0;
        for (std::size_t i = 0; i < followed_.size(); ++i) {
            const auto& known = followed_[i].classes;
            const auto place = std::ranges::find(known, classes[i]) - known.begin();
            way = way * known.size() + static_cast<std::size_t>(place);
        }
        if (ways_[way].obligation >= obligations_.size()) return build::name(free_process);
        Exprs arguments{build::number(0)};
        for (std::size_t i = 0; i < followed_.size(); ++i) arguments.push_back(build::name(fmt::format("a{}", i)));
        return build::prefix(build::dot({build::name(asked_event), build::number(static_cast<std::int64_t>(way))}),
                             build::call(open_process(ways_[way].obligation, false), std::move(arguments)));
    }
    Tree result;
    const auto& known = followed_[from].classes;
    for (auto at = known.rbegin(); at != known.rend(); ++at) {
        classes.push_back(*at);
        const Tree then = start_call(from + 1, classes);
        classes.pop_back();
        result = result
                     ? build::if_(build::binary(ExprKind::equal, build::name(class_variable(from)), build::number(*at)),
                                  then, result)
                     : then;
    }
    return result;
}

/// Defines sleec_Start0(k..), which assumes values for unknown measures. The parameters a.. are the assumed values,
/// which are compared with later readings at this instant.
std::vector<DeclPtr> Watch::start_definitions() const {
    std::vector<DeclPtr> result;
    const std::size_t count = followed_.size();
    const auto named = [](std::size_t place) { return fmt::format("sleec_Start{}", place); };
    for (std::size_t i = 0; i <= count; ++i) {
        std::vector<std::string> parameters;
        for (std::size_t k = 0; k < count; ++k) parameters.push_back(class_variable(k));
        for (std::size_t k = 0; k < i; ++k) parameters.push_back(fmt::format("a{}", k));
        const auto with = [&](const Tree& value, const Tree& assumed) {
            Exprs arguments;
            for (const std::string& parameter : parameters) arguments.push_back(build::name(parameter));
            if (i < count) arguments[i] = value;
            arguments.push_back(assumed);
            return build::call(named(i + 1), std::move(arguments));
        };
        Tree body;
        if (i == count) {
            body = start_call(0, {});
        } else {
            Exprs assumed;
            for (const std::int64_t class_value : followed_[i].classes)
                assumed.push_back(with(build::number(class_value), build::number(class_value)));
            const Tree value = build::name(class_variable(i));
            const bool compared = readings_ == Readings::one_value && !is_state(i);
            body = build::if_(build::binary(ExprKind::equal, value, build::number(unknown)),
                              build::internal_choice(std::move(assumed)),
                              with(value, compared ? value : build::number(unknown)));
        }
        result.push_back(build::function_decl(named(i), build::variables(parameters), body));
    }
    return result;
}

/// Returns the value of a measure at this instant, after a reading `v`.
Tree Watch::class_of_reading(std::size_t place) const {
    const Tree read = class_of(followed_[place], build::name("v"));
    if (readings_ == Readings::any) return read;
    const Tree before = build::name(class_variable(place));
    return build::if_(build::any_of({build::binary(ExprKind::equal, before, build::number(unknown)),
                                     build::binary(ExprKind::equal, before, read)}),
                      read, build::number(changing));
}

/// Defines the process before a trigger is selected. The process may select any trigger and follow its obligation.
std::vector<DeclPtr> Watch::idle_definitions() const {
    Exprs measures, not_read, changes;
    std::vector<std::string> parameters;
    for (std::size_t i = 0; i < followed_.size(); ++i) {
        parameters.push_back(class_variable(i));
        measures.push_back(build::name(class_variable(i)));
        not_read.push_back(is_state(i) ? measures.back() : build::number(unknown));
        changes.push_back(build::binary(ExprKind::equal, measures.back(), build::number(changing)));
    }
    Exprs choices;
    for (const std::size_t event : event_indices())
        choices.push_back(any_event(event, build::call(idle_process, measures)));
    const Tree start = build::call("sleec_Start0", measures);
    const bool guarded = readings_ == Readings::one_value && !changes.empty();
    choices.push_back(any_event(
        rules_.rules[rule_].trigger,
        guarded ? build::if_(build::any_of(std::move(changes)), build::call(idle_process, measures), start) : start));
    for (std::size_t i = 0; i < followed_.size(); ++i) {
        const LinkedMeasure* linked = channel_of(i);
        if (linked == nullptr) continue;
        Exprs arguments = measures;
        arguments[i] = class_of_reading(i);
        choices.push_back(build::prefix(build::name(linked->channel), {build::input("d"), build::input("v")},
                                        build::call(idle_process, std::move(arguments))));
    }
    for (const std::string& channel : state_channels())
        choices.push_back(show_states(channel, idle_process, measures, 0, true));
    choices.push_back(build::prefix(build::name("tock"), build::call(idle_process, not_read)));
    return {build::function_decl(idle_process, build::variables(parameters), build::choice(std::move(choices)))};
}

/// Returns the process for an event that breaks the obligation. The obligation is not broken if a later reading at the
/// trigger's instant shows a value other than the assumed one.
Tree Watch::violation_process() const {
    if (!reads_measures()) return break_process();
    Exprs same;
    for (std::size_t i = 0; i < followed_.size(); ++i) same.push_back(build::name(class_variable(i)));
    return build::if_(build::binary(ExprKind::greater, time_variable(), build::number(0)), break_process(),
                      build::call(wrong_process, std::move(same)));
}

/// Reads a measure while an obligation is open. A value other than the assumed one discards the run.
Tree Watch::compare_reading(std::size_t place, const Tree& then) const {
    const Tree assumed = build::name(class_variable(place));
    const Tree other =
        build::all_of({build::binary(ExprKind::greater_equal, assumed, build::number(0)),
                       build::binary(ExprKind::not_equal, assumed, class_of(followed_[place], build::name("v")))});
    return build::prefix(build::name(linking_.measures[followed_[place].measure]->channel),
                         {build::input("d"), build::input("v")}, build::if_(other, build::name(free_process), then));
}

/// Returns the values of the measures after a reading that agreed with the assumed value.
Exprs Watch::arguments_after_reading(std::size_t place) const {
    Exprs result;
    for (std::size_t k = 0; k < followed_.size(); ++k)
        result.push_back(k == place && readings_ == Readings::any ? build::number(unknown)
                                                                  : build::name(class_variable(k)));
    return result;
}

std::vector<DeclPtr> Watch::wrong_definitions() const {
    if (!reads_measures()) return {};
    Exprs choices, same;
    std::vector<std::string> parameters;
    for (std::size_t i = 0; i < followed_.size(); ++i) {
        parameters.push_back(class_variable(i));
        same.push_back(build::name(class_variable(i)));
    }
    for (const std::size_t event : event_indices())
        choices.push_back(any_event(event, build::call(wrong_process, same)));
    for (const std::string& channel : state_channels())
        choices.push_back(show_states(channel, wrong_process, same, 0, false));
    for (std::size_t i = 0; i < followed_.size(); ++i)
        if (channel_of(i) != nullptr)
            choices.push_back(compare_reading(i, build::call(wrong_process, arguments_after_reading(i))));
    choices.push_back(build::prefix(build::name("tock"), break_process()));
    return {build::function_decl(wrong_process, build::variables(parameters), build::choice(std::move(choices)))};
}

/// Returns the continuation after an event. Corresponds to take_event (obligations/open.hpp).
Tree Watch::on_event(std::size_t index, bool broken, std::size_t event) const {
    const Obligation& obligation = obligations_[index];
    const auto& ended_by = obligation.ended_by;
    if (std::ranges::find(ended_by, event) != ended_by.end()) return build::name(free_process);
    Exprs same{time_variable()};
    for (std::size_t i = 0; i < followed_.size(); ++i) same.push_back(build::name(class_variable(i)));
    Tree result = build::call(open_process(index, broken), same);
    const Demand* forbidden = find_prohibition(obligation);
    if (forbidden != nullptr && forbidden->event.contains(event) && !broken)
        result = build::if_(
            within_window(*forbidden),
            build::if_(can_still_be_met(obligation), build::call(open_process(index, true), same), violation_process()),
            result);
    Exprs fulfilled;
    for (const Demand& demand : obligation.any)
        if (!demand.forbids && demand.event.contains(event)) fulfilled.push_back(within_window(demand));
    return fulfilled.empty() ? result
                             : build::if_(build::any_of(std::move(fulfilled)), build::name(free_process), result);
}

/// Returns the continuation after the second `t`. Corresponds to take_tock.
Tree Watch::on_tock(std::size_t index, bool broken) const {
    const Obligation& obligation = obligations_[index];
    const std::int64_t last = last_second(obligation);
    const Tree next = build::binary(ExprKind::plus, time_variable(), build::number(1));
    Exprs arguments{
        build::if_(build::binary(ExprKind::less, time_variable(), build::number(last)), next, time_variable())};
    for (std::size_t i = 0; i < followed_.size(); ++i) arguments.push_back(build::number(unknown));
    Tree result = build::call(open_process(index, broken), std::move(arguments));
    const auto ends_now = [&](const Demand& demand) {
        return build::binary(ExprKind::less_equal, build::number(demand.end), time_variable());
    };
    const Demand* forbidden = find_prohibition(obligation);
    if (forbidden != nullptr && !broken)
        return forbidden->end == forever ? result : build::if_(ends_now(*forbidden), build::name(free_process), result);
    Exprs over;
    for (const Demand& demand : obligation.any) {
        if (demand.forbids) continue;
        if (demand.end == forever) return result;
        over.push_back(ends_now(demand));
    }
    return build::if_(build::all_of(std::move(over)), break_process(), result);
}

/// Returns the event for the passing of a second while this obligation is open.
Tree Watch::time_event(std::size_t index) const {
    return build::name(waits_forever(obligations_[index]) ? waiting : "tock");
}

std::vector<DeclPtr> Watch::open_definitions(std::size_t index) const {
    std::vector<DeclPtr> result;
    std::vector<std::string> parameters{"t"};
    for (std::size_t i = 0; i < followed_.size(); ++i) parameters.push_back(class_variable(i));
    for (const bool broken : {false, true}) {
        if (broken && find_prohibition(obligations_[index]) == nullptr) continue;
        Exprs choices;
        for (const std::size_t event : event_indices())
            choices.push_back(any_event(event, on_event(index, broken, event)));
        Exprs same;
        for (const std::string& parameter : parameters) same.push_back(build::name(parameter));
        for (const std::string& channel : state_channels())
            choices.push_back(show_states(channel, open_process(index, broken), same, 1, false));
        for (std::size_t i = 0; i < followed_.size(); ++i) {
            if (channel_of(i) == nullptr) continue;
            Exprs arguments = arguments_after_reading(i);
            arguments.insert(arguments.begin(), time_variable());
            choices.push_back(compare_reading(i, build::call(open_process(index, broken), std::move(arguments))));
        }
        choices.push_back(build::prefix(time_event(index), on_tock(index, broken)));
        result.push_back(build::function_decl(open_process(index, broken), build::variables(parameters),
                                              build::choice(std::move(choices))));
    }
    return result;
}

std::vector<DeclPtr> Watch::declarations() const {
    std::vector<DeclPtr> result{
        build::channel({broken_event, waiting}),
        build::channel({asked_event},
                       build::set_range(build::number(0), build::number(static_cast<std::int64_t>(ways_.size()) - 1))),
        build::value(all_events, named_events()),
        build::value(free_process,
                     build::replicated(ExprKind::replicated_external, {build::generator("x", build::name(all_events))},
                                       build::prefix(build::name("x"), build::name(free_process)))),
        build::value("sleec_Seconds",
                     build::choice({build::prefix(build::name("tock"), build::name("sleec_Seconds")),
                                    build::prefix(build::name(waiting), build::name("sleec_Seconds"))})),
        build::value("sleec_Over", build::prefix(build::name("tock"), build::name("sleec_Over")))};
    const auto add = [&](std::vector<DeclPtr> more) { result.insert(result.end(), more.begin(), more.end()); };
    add(idle_definitions());
    add(start_definitions());
    add(wrong_definitions());
    for (std::size_t i = 0; i < obligations_.size(); ++i) add(open_definitions(i));
    return result;
}

bool Watch::has_demand_without_limit() const {
    return std::ranges::any_of(obligations_, waits_forever);
}

bool Watch::reads_measures() const {
    for (std::size_t i = 0; i < followed_.size(); ++i)
        if (channel_of(i) != nullptr) return true;
    return false;
}

/// Returns the component in parallel with the rule. A terminated component has no further steps, but time continues.
Tree Watch::parallel_process() const {
    Exprs not_read;  // at first, machines are in no state
    for (std::size_t i = 0; i < followed_.size(); ++i) not_read.push_back(build::number(is_state(i) ? 0 : unknown));
    Tree component = build::sequential({process_, build::name("sleec_Over")});
    Tree shared = build::name(all_events);
    if (has_demand_without_limit()) {
        const Tree tock = build::name("tock"), wait = build::name(waiting);
        component = build::rename(component, {{tock, tock}, {tock, wait}});
        shared = build::call("union", {shared, build::set({wait})});
    }
    return build::parallel(component, shared, build::call(idle_process, std::move(not_read)));
}

Tree Watch::waiting_process() const {
    return both_showing(build::set({build::name(waiting)}));
}

Tree Watch::both_showing(const Tree& events) const {
    return build::hide(parallel_process(), build::call("diff", {build::name("Events"), events}));
}

DeclPtr Watch::obeyed_assertion() const {
    const Tree events = build::set({build::name(broken_event), build::name("tock"), build::name(waiting)});
    return build::assert_refines(build::name("sleec_Seconds"), cspm::Model::traces, both_showing(events));
}

DeclPtr Watch::never_asked_assertion(const std::vector<std::size_t>& ways) const {
    Exprs events;
    for (const std::size_t way : ways)
        events.push_back(build::dot({build::name(asked_event), build::number(static_cast<std::int64_t>(way))}));
    return build::assert_refines(build::stop(), cspm::Model::traces, both_showing(build::set(std::move(events))));
}

}  // namespace robochart::sleec
