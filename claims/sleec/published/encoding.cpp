// SPDX-License-Identifier: Apache-2.0
// See encoding.hpp. Each function states the part of SLEEC-TK's semantics that it implements.
#include "claims/sleec/published/encoding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "checker/cspm/syntax/build.hpp"

namespace robochart::sleec {
namespace {

namespace build = cspm::build;
using build::Decls;
using build::Exprs;
using cspm::DeclPtr;
using cspm::ExprKind;
using Tree = cspm::ExprPtr;

/// Collects the measures in textual order, once for each mention.
void collect_mentions(const Condition& condition, std::vector<std::size_t>& result) {
    if (condition.op == Op::name) result.push_back(condition.measure);
    for (const Condition& part : condition.parts) collect_mentions(part, result);
}

void events_in(const DutyPtr& duty, std::vector<std::size_t>& events) {
    if (!duty) return;
    for (const std::size_t event : duty->event)
        if (std::ranges::find(events, event) == events.end()) events.push_back(event);
    events_in(duty->otherwise, events);
    for (const CheckedDefeater& defeater : duty->defeaters) events_in(defeater.duty, events);
}

ExprKind kind_of(Op op) {
    switch (op) {
        case Op::disjunction:
            return ExprKind::logical_or;
        case Op::conjunction:
            return ExprKind::logical_and;
        case Op::less:
            return ExprKind::less;
        case Op::less_equal:
            return ExprKind::less_equal;
        case Op::greater:
            return ExprKind::greater;
        case Op::greater_equal:
            return ExprKind::greater_equal;
        case Op::equal:
            return ExprKind::equal;
        case Op::unequal:
        case Op::truth:
        case Op::number:
        case Op::name:
        case Op::in_state:
        case Op::negation:
        case Op::add:
        case Op::subtract:
        case Op::multiply:
            break;
    }
    return ExprKind::not_equal;
}

/// Names of timing events cannot clash with names of rule events, which have a prefix.
constexpr const char* tock = "tock";
constexpr const char* other_tock = "tock'";

Tree tock_then(Tree process) {
    return build::prefix(build::name(tock), std::move(process));
}

}  // namespace

Encoding::Encoding(const CheckedRules& rules, EncodingNames names) : rules_(rules), names_(std::move(names)) {
    std::vector<std::size_t> all(rules.rules.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    values_ = representative_values(rules, all);
}

std::string Encoding::event_name(std::size_t event) const {
    return names_.prefix + rules_.event_name(event);
}

std::string Encoding::measure_name(std::size_t measure) const {
    return names_.prefix + rules_.measure(measure).name.text;
}

std::string Encoding::process_name(std::size_t rule) const {
    return name(fmt::format("Rule{}", rule));
}

std::vector<DeclPtr> Encoding::channel_declarations() const {
    Decls result{build::external({"prioritise"}), build::channel({tock, other_tock}),
                 build::function_decl("OneStep", {build::wildcard()}, build::number(0))};
    for (std::size_t i = 0; i < rules_.events.size(); ++i)
        if (rules_.events[i].values.empty()) result.push_back(build::channel({event_name(i)}));
    for (std::size_t i = 0; i < rules_.file->measures.size(); ++i) {
        Tree type = build::name("Bool");
        if (rules_.measure(i).type != MeasureType::boolean) {
            Exprs items;
            for (const std::int64_t value : values_[i]) items.push_back(build::number(value));
            type = build::set(std::move(items));
        }
        result.push_back(build::channel({measure_name(i), "i_" + measure_name(i)}, type));
    }
    return result;
}

// ---------------------------------------------------------------- conditions

bool Encoding::on_scale(const Condition& condition) const {
    return condition.op == Op::name && rules_.measure(condition.measure).type == MeasureType::scale;
}

/// Returns the condition as an expression, in which values of a scale are indices. SLEEC-TK reads `>=` with a measure
/// on a scale as `>`, which is a fault.
Tree Encoding::condition_expression(const Condition& condition) const {
    switch (condition.op) {
        case Op::truth:
            return build::boolean(condition.value != 0);
        case Op::number:
            return build::number(condition.value);
        case Op::name:
        case Op::in_state:
            return build::name("v_" + measure_name(condition.measure));
        case Op::negation:
            return build::logical_not(condition_expression(condition.parts[0]));
        case Op::add:
        case Op::subtract:
        case Op::multiply:
            return build::number(evaluate_condition(condition, {}));
        case Op::disjunction:
        case Op::conjunction:
        case Op::less:
        case Op::less_equal:
        case Op::greater:
        case Op::greater_equal:
        case Op::equal:
        case Op::unequal:
            break;
    }
    ExprKind kind = kind_of(condition.op);
    if (kind == ExprKind::greater_equal && (on_scale(condition.parts[0]) || on_scale(condition.parts[1])))
        kind = ExprKind::greater;
    return build::binary(kind, condition_expression(condition.parts[0]), condition_expression(condition.parts[1]));
}

/// Reads the measures without delay, in textual order, once for each mention.
Tree Encoding::read_measures(const std::vector<const Condition*>& conditions, Tree then) const {
    std::vector<std::size_t> order;
    for (const Condition* condition : conditions) collect_mentions(*condition, order);
    for (auto at = order.rbegin(); at != order.rend(); ++at) {
        const std::string measure = measure_name(*at);
        then = build::call(name("StartBy"), {build::prefix(build::name(measure), {build::input("v_" + measure)}, then),
                                             build::number(0)});
    }
    return then;
}

// ---------------------------------------------------------------- rules

/// Returns `e -> reading -> if c then SKIP else again`. The events of the response are always allowed meanwhile.
Tree Encoding::trigger_process(const CheckedRule& rule, const std::string& self) const {
    const Tree again = build::name(self);
    Tree then = build::skip();
    if (rule.condition)
        then = read_measures({&*rule.condition}, build::if_(condition_expression(*rule.condition), then, again));
    Exprs choices{build::prefix(build::name(event_name(*rule.trigger.begin())), then)};
    std::vector<std::size_t> free;
    events_in(rule.duty, free);
    for (const std::size_t event : free) choices.push_back(build::prefix(build::name(event_name(event)), again));
    return build::choice(std::move(choices));
}

/// Returns the process of a response. `E` has no limit. After `E within d`, E occurs at 0 to d, or time stops. After
/// `not E within d`, E is refused for d units. After `E within d otherwise r`, E occurs before d units, or the rule
/// continues as r at d. Defeaters of a response inside a defeater are dropped.
Tree Encoding::response_process(const DutyPtr& duty) const {
    if (duty->measured) throw NotDecided("SLEEC-TK has no limits that a measure decides");
    if (duty->written->limit && duty->written->limit->from) throw NotDecided("SLEEC-TK has no intervals of time");
    if (duty->forbids) {
        if (!duty->to || duty->otherwise)
            throw NotDecided("SLEEC-TK has no 'not' without 'within', or with 'otherwise'");
        return build::call("WAIT", {build::number(*duty->to)});
    }
    const Tree event = build::prefix(build::name(event_name(*duty->event.begin())), build::skip());
    if (!duty->otherwise) {
        if (!duty->to) return event;
        return build::call(name("StartBy"), {event, build::number(*duty->to)});
    }
    if (!duty->to) throw NotDecided("SLEEC-TK has no 'otherwise' without 'within'");
    if (!duty->otherwise->defeaters.empty())
        throw NotDecided("the meaning of defeaters after 'otherwise' in SLEEC-TK is unknown");
    return build::call(name("Before"), {event, build::number(*duty->to), response_process(duty->otherwise)});
}

/// Reads all measures of all defeaters; the last defeater whose condition is true decides.
Tree Encoding::monitoring_process(const CheckedRule& rule) const {
    std::vector<const Condition*> conditions;
    Tree decided = response_process(rule.duty);
    for (const CheckedDefeater& defeater : rule.duty->defeaters) {
        if (defeater.event) throw NotDecided("SLEEC-TK has no events behind 'unless'");
        conditions.push_back(&defeater.condition);
        decided = build::if_(condition_expression(defeater.condition),
                             defeater.duty ? response_process(defeater.duty) : build::skip(), decided);
    }
    return read_measures(conditions, decided);
}

void Encoding::require_published(std::size_t rule) const {
    for (const std::size_t event : events_of(rule))
        if (!rules_.events[event].values.empty()) throw NotDecided("SLEEC-TK has no arguments of events");
    for (const std::size_t measure : measures_of(rules_.rules[rule]))
        if (rules_.is_state(measure)) throw NotDecided("SLEEC-TK has no states of the model");
}

std::vector<DeclPtr> Encoding::process_declarations(const std::vector<std::size_t>& rule_numbers) const {
    const auto var = [](const char* text) { return build::name(text); };
    const Tree stop = build::call(name("TimeStops"));
    const Tree tocks = build::set({build::name(tock)});
    Decls result{build::value(name("TimeStops"), build::stop())};
    // In Before(P, d, Q), P may begin before d units; at d, the process behaves as Q.
    result.push_back(build::function_decl(
        name("Before"), build::variables({"P", "d", "Q"}),
        build::let_({build::function_decl(
                        "B", build::variables({"n"}),
                        build::if_(build::binary(ExprKind::less, var("n"), var("d")),
                                   build::choice({build::synchronising_choice(build::stop(), tocks, var("P")),
                                                  tock_then(build::call("B", {build::binary(ExprKind::plus, var("n"),
                                                                                            build::number(1))}))}),
                                   var("Q")))},
                    build::call("B", {build::number(0)}))));
    Decls timed{
        build::function_decl(name("StartBy"), build::variables({"P", "d"}),
                             build::choice({var("P"), build::sequential({build::call("WAIT", {var("d")}), stop})}))};
    for (const std::size_t rule : rule_numbers) {
        const CheckedRule& checked_rule = rules_.rules[rule];
        require_published(rule);
        const std::string trigger_name = name(fmt::format("Trigger{}", rule));
        const std::string whole = name(fmt::format("Whole{}", rule));
        timed.push_back(build::value(trigger_name, trigger_process(checked_rule, trigger_name)));
        timed.push_back(build::value(whole, build::sequential({build::name(trigger_name),
                                                               monitoring_process(checked_rule), build::name(whole)})));
        timed.push_back(build::value(process_name(rule), build::call("timed_priority", {build::name(whole)})));
    }
    result.push_back(build::timed(build::name("OneStep"), std::move(timed)));
    return result;
}

// ---------------------------------------------------------------- pairs

std::vector<std::size_t> Encoding::events_of(std::size_t rule) const {
    const EventCases& trigger = rules_.rules[rule].trigger;
    std::vector<std::size_t> events(trigger.begin(), trigger.end());
    events_in(rules_.rules[rule].duty, events);
    return events;
}

std::vector<std::size_t> Encoding::measures_of_pair(std::size_t first, std::size_t second) const {
    std::vector<std::size_t> result = measures_of(rules_.rules[first]);
    for (const std::size_t measure : measures_of(rules_.rules[second]))
        if (std::ranges::find(result, measure) == result.end()) result.push_back(measure);
    std::ranges::sort(result);
    return result;
}

bool Encoding::are_related(std::size_t first, std::size_t second) const {
    const auto meet = [](const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
        return std::ranges::find_first_of(a, b) != a.end();
    };
    return meet(events_of(first), events_of(second)) ||
           meet(measures_of(rules_.rules[first]), measures_of(rules_.rules[second]));
}

Tree Encoding::measure_events(const std::vector<std::size_t>& measures) const {
    Exprs items;
    for (const std::size_t measure : measures) items.push_back(build::name(measure_name(measure)));
    return build::productions(std::move(items));
}

Tree Encoding::event_set(const std::vector<std::size_t>& events) const {
    Exprs items;
    for (const std::size_t event : events) items.push_back(build::name(event_name(event)));
    return build::set(std::move(items));
}

/// Returns the rules in parallel, synchronised on their common events. Each rule reads the measures separately, from an
/// environment that keeps the first value forever. A missed deadline is a deadlock. A state in which only time passes
/// diverges after time is hidden, because all other events have priority over time.
std::vector<DeclPtr> Encoding::conflict_declarations(std::size_t first, std::size_t second) const {
    std::vector<std::size_t> common;
    const std::vector<std::size_t> others = events_of(second);
    for (const std::size_t event : events_of(first))
        if (std::ranges::find(others, event) != others.end()) common.push_back(event);
    const std::string id = fmt::format("{}_{}", first, second);
    Decls timed;
    Exprs environment;
    const std::vector<std::size_t> measures = measures_of_pair(first, second);
    for (const std::size_t measure : measures) {
        const std::string fixed = name(fmt::format("Fixed{}_{}", id, measure));
        const Tree channel = build::name(measure_name(measure));
        timed.push_back(build::function_decl(
            fixed, build::variables({"x"}),
            build::prefix(channel, {build::output(build::name("x"))}, build::call(fixed, {build::name("x")}))));
        environment.push_back(build::prefix(channel, {build::input("x")}, build::call(fixed, {build::name("x")})));
    }
    const auto whole = [&](std::size_t rule) { return build::name(name(fmt::format("Whole{}", rule))); };
    Tree both = build::parallel(whole(first), event_set(common), whole(second));
    if (!environment.empty())
        both = build::parallel(both, measure_events(measures), build::interleave(std::move(environment)));
    const std::string conflict = name("Both" + id);
    timed.push_back(build::value(conflict, build::call("timed_priority", {both})));
    Decls result{build::timed(build::name("OneStep"), std::move(timed))};
    const auto name_of = [](const char* text) { return build::name(text); };
    const Tree doubled =
        build::rename(build::name(conflict), {{name_of(tock), name_of(tock)}, {name_of(tock), name_of(other_tock)}});
    const Tree order =
        build::sequence({build::call("diff", {name_of("Events"), build::set({name_of(other_tock), name_of(tock)})}),
                         build::set({name_of(tock)})});
    const std::string waiting = name("Waiting" + id);
    result.push_back(
        build::value(waiting, build::hide(build::call("prioritise", {doubled, order}), build::set({name_of(tock)}))));
    result.push_back(build::assert_property(build::name(conflict), cspm::AssertionKind::deadlock_free));
    result.push_back(build::assert_property(build::name(waiting), cspm::AssertionKind::divergence_free));
    return result;
}

/// Returns the memory of the measures. Each unit of time begins with one reading of every measure. Then the measures
/// keep these values, and the events of both rules may occur. SLEEC-TK reads the measures one after another in a fixed
/// order. This encoding reads them in a single event, which is equivalent.
std::vector<DeclPtr> Encoding::memory_declarations(std::size_t first, std::size_t second,
                                                   const std::string& called) const {
    const std::vector<std::size_t> measures = measures_of_pair(first, second);
    std::vector<std::size_t> events = events_of(first);
    for (const std::size_t event : events_of(second))
        if (std::ranges::find(events, event) == events.end()) events.push_back(event);
    const std::string provide = "Provide" + called;
    Exprs parameters, offered, types;
    std::vector<std::string> variables;
    std::vector<cspm::Field> fields;
    for (const std::size_t measure : measures) {
        const std::string variable = "v_" + measure_name(measure);
        variables.push_back(variable);
        parameters.push_back(build::name(variable));
        fields.push_back(build::input(variable));
        offered.push_back(build::dot({build::name("i_" + measure_name(measure)), build::name(variable)}));
        Exprs items;
        for (const std::int64_t value : values_[measure]) items.push_back(build::number(value));
        types.push_back(rules_.measure(measure).type == MeasureType::boolean ? build::name("Bool")
                                                                             : build::set(std::move(items)));
    }
    for (const std::size_t event : events) offered.push_back(build::name(event_name(event)));
    const Tree again = build::call(provide, parameters);
    const Tree some = build::replicated(ExprKind::replicated_external,
                                        {build::generator(build::variable("x"), build::set(std::move(offered)))},
                                        build::prefix(build::name("x"), again));
    Decls result;
    Tree next = again;
    if (!measures.empty()) {
        result.push_back(build::channel({"read" + called}, build::dot(std::move(types))));
        next = build::name(called);
    }
    result.push_back(
        build::function_decl(provide, build::variables(variables), build::choice({some, tock_then(next)})));
    Tree start = again;
    if (!measures.empty())
        start = build::choice({build::prefix(build::name("read" + called), std::move(fields), again), tock_then(next)});
    result.push_back(build::value(called, start));
    return result;
}

/// Returns the rule in parallel with the memory, from which the rule reads by hidden events.
DeclPtr Encoding::with_memory(std::size_t rule, std::size_t other, const std::string& memory,
                              const std::string& called) const {
    std::vector<cspm::Link> links;
    Exprs internal;
    for (const std::size_t measure : measures_of_pair(rule, other)) {
        links.push_back({build::name(measure_name(measure)), build::name("i_" + measure_name(measure))});
        internal.push_back(build::name("i_" + measure_name(measure)));
    }
    Tree process = build::name(this->process_name(rule));
    if (!links.empty()) process = build::rename(process, std::move(links));
    const Tree readings = build::productions(internal);
    process = build::parallel(process, build::union_of({event_set(events_of(rule)), readings}), build::name(memory));
    if (!internal.empty()) process = build::hide(process, readings);
    return build::value(called, build::call("timed_priority", {process}));
}

std::vector<DeclPtr> Encoding::pair_declarations(std::size_t first, std::size_t second) const {
    Decls result = conflict_declarations(first, second);
    const std::string id = fmt::format("{}_{}", first, second);
    const std::string shared = name("Memory" + id);
    for (DeclPtr& declaration : memory_declarations(first, second, shared)) result.push_back(std::move(declaration));
    const std::string one = name("First" + id), two = name("Second" + id);
    result.push_back(build::timed(build::name("OneStep"),
                                  {with_memory(first, second, shared, one), with_memory(second, first, shared, two)}));
    result.push_back(build::assert_refines(build::name(one), cspm::Model::traces, build::name(two)));
    result.push_back(build::assert_refines(build::name(two), cspm::Model::traces, build::name(one)));
    return result;
}

cspm::Script Encoding::make_script(const std::vector<std::pair<std::size_t, std::size_t>>& pairs) const {
    std::vector<std::size_t> rule_numbers;
    for (const auto& [first, second] : pairs)
        for (const std::size_t rule : {first, second})
            if (std::ranges::find(rule_numbers, rule) == rule_numbers.end()) rule_numbers.push_back(rule);
    std::ranges::sort(rule_numbers);
    cspm::Script script;
    const auto add = [&](Decls decls) { script.decls.insert(script.decls.end(), decls.begin(), decls.end()); };
    add(channel_declarations());
    add(process_declarations(rule_numbers));
    for (const auto& [first, second] : pairs) add(pair_declarations(first, second));
    return script;
}

}  // namespace robochart::sleec
