// SPDX-License-Identifier: Apache-2.0
// Checks packages, units, components and forms of claims. See check.hpp.
#include "claims/checks/check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <set>
#include <tuple>

#include "base/diagnostics/spelling.hpp"
#include "claims/checks/duration.hpp"
#include "claims/checks/resolve_constants.hpp"
#include "claims/checks/resolve_events.hpp"
#include "claims/checks/resolve_facts.hpp"
#include "claims/checks/rules.hpp"
#include "claims/checks/unit.hpp"

namespace robochart::claims {
namespace {

/// True if every event of the first set certainly belongs to the second. Conditions are not compared: a match of the
/// second set that has a condition is treated as if it contained no event.
bool is_within(const Events& one, const Events& other) {
    if ((one.start && !other.start) || (one.terminate && !other.terminate)) return false;
    std::set<std::size_t> whole;
    for (const EventMatch& match : other.any)
        if (!match.condition) whole.insert(match.channels.begin(), match.channels.end());
    return std::ranges::all_of(one.any, [&](const EventMatch& match) {
        return std::ranges::all_of(match.channels, [&](std::size_t channel) { return whole.contains(channel); });
    });
}

class Checker {
public:
    Checker(const ClaimedModel& model, const diagnostics::SourceManager& sources, diagnostics::Diagnostics& diagnostics)
        : model_(model), sources_(sources), diagnostics_(diagnostics), components_(components_of(model.system)) {}

    CheckedClaims check(const std::vector<std::shared_ptr<const ClaimFile>>& files) {
        if (const auto unit = find_unit(files, sources_, diagnostics_)) result_.unit = unit->nanoseconds;
        std::set<std::string> names(model_.names.begin(), model_.names.end());
        for (const auto& file : files) {
            check_imports(*file);
            for (const Claim& claim : file->claims) {
                diagnostics_.poll();
                if (!names.insert(claim.name.text).second)
                    diagnostics_.report(rules::named_twice, claim.name.span, {claim.name.text});
                try {
                    result_.claims.push_back(check_claim(claim, *file));
                } catch (const ClaimError&) {
                }
            }
            for (const Order& order : file->orders) {
                try {
                    add_order(check_order(order, *file), order);
                } catch (const ClaimError&) {
                }
            }
        }
        return std::move(result_);
    }

private:
    void check_imports(const ClaimFile& file) {
        for (const Import& import : file.imports) {
            const auto known = std::ranges::find(model_.packages, import.name.text);
            if (known != model_.packages.end()) continue;
            const std::string meant = diagnostics::nearest_spelling(import.name.text, model_.packages);
            diagnostics_.report(rules::unknown_package, import.name.span,
                                {import.name.text, meant.empty() ? "" : fmt::format("; did you mean `{}`?", meant)});
        }
    }

    // ------------------------------------------------------------ components

    [[nodiscard]] static bool is_visible(const Component& component, const ClaimFile& file) {
        if (file.imports.empty() && !file.package) return true;
        if (component.package.empty() || (file.package && file.package->text == component.package)) return true;
        return std::ranges::any_of(file.imports,
                                   [&](const Import& import) { return import.name.text == component.package; });
    }

    [[nodiscard]] std::vector<const Component*> visible_components(const ClaimFile& file) const {
        std::vector<const Component*> result;
        for (const Component& component : components_)
            if (is_visible(component, file)) result.push_back(&component);
        return result;
    }

    /// Removes the RoboSim components if the name denotes components of both notations. The claim is then about the
    /// RoboChart component.
    static void prefer_robochart(std::vector<const Component*>& components) {
        const auto in_robosim = [](const Component* component) { return component->robosim; };
        if (!std::ranges::all_of(components, in_robosim)) std::erase_if(components, in_robosim);
    }

    static std::string list(const std::vector<const Component*>& components) {
        std::vector<std::string> paths;
        for (const Component* component : components) paths.push_back(component->path);
        constexpr std::size_t shown = 5;
        if (paths.size() > shown) {
            paths.resize(shown);
            paths.emplace_back("...");
        }
        return fmt::format("{}", fmt::join(paths, ", "));
    }

    /// Returns the only module; without modules the only controller; without controllers the only machine.
    [[nodiscard]] const Component& only_component(const Claim& claim, const ClaimFile& file) const {
        for (const ir::ComponentKind kind :
             {ir::ComponentKind::module, ir::ComponentKind::controller, ir::ComponentKind::machine}) {
            std::vector<const Component*> found = visible_components(file);
            prefer_robochart(found);
            std::erase_if(found, [&](const Component* one) { return one->kind != kind || one->part; });
            if (found.size() == 1) return *found.front();
            if (found.size() > 1)
                refuse_component(claim.name.span,
                                 fmt::format("which component is `{}` about? Write `claim {} of {} : ...`; "
                                             "there are {}",
                                             claim.name.text, claim.name.text, found.front()->path, list(found)));
        }
        refuse_component(claim.name.span, "the claim is about no component: no model is beside it");
    }

    [[noreturn]] void refuse_component(Span span, std::string text) const {
        diagnostics_.report(rules::unknown_component, span, {std::move(text)});
        throw ClaimError{};
    }

    /// If several parts have the name, the result is the part of the component with the path `inside`.
    [[nodiscard]] const Component& named_component(const Name& name, const ClaimFile& file,
                                                   const std::string& inside) const {
        const std::vector<const Component*> visible = visible_components(file);
        std::vector<const Component*> found, exact;
        for (const Component* component : visible) {
            if (component->path != name.text && !component->path.ends_with("::" + name.text)) continue;
            // A controller that is declared in its module is listed on its own, too, with parts of the same paths.
            const auto is_same = [&](const Component* other) {
                return other->path == component->path && other->robosim == component->robosim;
            };
            if (std::ranges::none_of(found, is_same)) found.push_back(component);
            if (!component->part) exact.push_back(component);
        }
        prefer_robochart(exact);
        if (exact.empty()) prefer_robochart(found);
        if (exact.size() == 1) return *exact.front();
        const auto is_inside = [&](const Component* part) { return part->path.starts_with(inside + "::"); };
        if (exact.empty() && std::ranges::any_of(found, is_inside)) std::erase_if(found, std::not_fn(is_inside));
        if (found.size() == 1) return *found.front();
        if (found.size() > 1)
            refuse_component(name.span, fmt::format("`{}` is not unique: there are {}", name.text, list(found)));
        std::vector<std::string> names;
        for (const Component* component : visible) {
            names.push_back(component->path);
            names.push_back(component->path.substr(component->path.rfind(':') + 1));
        }
        const std::string meant = diagnostics::nearest_spelling(name.text, names);
        refuse_component(name.span, fmt::format("no module, controller or machine is called `{}`{}", name.text,
                                                meant.empty() ? "" : fmt::format("; did you mean `{}`?", meant)));
    }

    // ------------------------------------------------------------ orders

    CheckedOrder check_order(const Order& order, const ClaimFile& file) {
        CheckedOrder result;
        result.component = named_component(order.component, file, "");
        result.span = order.span;
        if (result.component.robosim)
            refuse(
                order.component.span,
                fmt::format("{} is written in RoboSim, and orders of events are for RoboChart: the conditions of its "
                            "transitions read all registers of a cycle",
                            result.component.path));
        if (!order.first.empty() && result.component.kind != ir::ComponentKind::machine)
            refuse(order.component.span, "a machine tries events first; `drops` is about a component");
        for (const Name& event : order.first) {
            require_input(result.component, event);
            const ir::Machine& machine = model_.system.machine(result.component.machines.front().machine);
            const bool taken = std::ranges::any_of(machine.transitions, [&](const ir::Transition& transition) {
                return transition.trigger && machine.events[transition.trigger->event.index].name == event.text;
            });
            if (!taken)
                refuse(event.span, fmt::format("no transition of {} is triggered by `{}`", machine.name, event.text));
            if (std::ranges::find(result.first, event.text) != result.first.end())
                refuse(event.span, fmt::format("`{}` comes first twice", event.text));
            result.first.push_back(event.text);
        }
        for (const Order::Drop& drop : order.drops) {
            require_input(result.component, drop.event);
            require_input(result.component, drop.dropped);
            if (drop.event.text == drop.dropped.text) refuse(drop.dropped.span, "an event does not drop itself");
            result.drops.push_back({drop.event.text, drop.dropped.text});
        }
        return result;
    }
    void add_order(CheckedOrder order, const Order& written) {
        for (const CheckedOrder& other : result_.orders)
            if (other.component.path == order.component.path && !other.first.empty() && !order.first.empty())
                refuse(written.component.span, fmt::format("two orders of {}: the other is in {}", order.component.path,
                                                           sources_.path_and_line(other.span)));
        result_.orders.push_back(std::move(order));
    }
    void require_input(const Component& component, const Name& event) {
        std::vector<std::string> inputs;
        for (const Channel& channel : component.channels)
            if (channel.kind == ChannelKind::input) inputs.push_back(channel.name);
        if (std::ranges::find(inputs, event.text) != inputs.end()) return;
        const std::string meant = diagnostics::nearest_spelling(event.text, inputs);
        refuse(event.span, fmt::format("{} does not receive an event `{}`{}", component.path, event.text,
                                       meant.empty() ? "" : fmt::format("; did you mean `{}`?", meant)));
    }

    // ------------------------------------------------------------ claims

    CheckedClaim check_claim(const Claim& claim, const ClaimFile& file) {
        CheckedClaim result;
        result.name = claim.name.text;
        result.wording = claim.wording;
        result.span = claim.span;
        result.component = claim.component ? named_component(*claim.component, file, "") : only_component(claim, file);
        result.assumption = claim.assumption;
        for (const Spontaneous& event : result.component.spontaneous)
            if (reported_.emplace(result.component.path, event.machine, event.event).second)
                diagnostics_.report(
                    rules::spontaneous_event, claim.name.span,
                    {event.event, event.machine, result.component.path, sources_.path_and_line(event.span)});
        result.raised = claim.scope.kind == ScopeKind::cycle;
        inputs_.clear();
        for (const Channel& channel : result.component.channels)
            if (channel.kind == ChannelKind::input) inputs_.insert(channel.name);
        EventResolver events(model_.system, result, sources_, diagnostics_);
        FactResolver facts(model_.system, result, sources_, diagnostics_);
        result.scope.kind = claim.scope.kind;
        result.scope.first = events.resolve(claim.scope.first);
        result.scope.last = events.resolve(claim.scope.last);
        if (claim.scope.condition) result.scope.condition = facts.resolve(*claim.scope.condition);
        if (claim.scope.kind == ScopeKind::for_after) result.scope.units = count_units(claim.scope.duration);
        const Body& body = claim.body;
        result.body.kind = body.kind;
        if (const ExprPtr state = state_of_possible(body, result, facts))
            result.body.condition = facts.resolve(*state);
        else
            result.body.events = events.resolve(body.events);
        result.body.others = events.resolve(body.others);
        result.body.exceptions = events.resolve(body.exceptions);
        if (body.condition) {
            result.body.condition = facts.resolve(*body.condition);
            result.body.condition_text = facts.written(body.condition->span);
        }
        if (body.duration) result.body.units = count_units(*body.duration);
        if (!body.count.empty()) result.body.count = Fraction::of_decimal(body.count).numerator();
        check_scope_of_cycle(result);
        check_meaning(claim, result);
        add_constants(claim, file, result);
        return result;
    }

    void add_constants(const Claim& claim, const ClaimFile& file, CheckedClaim& checked) {
        const ConstantResolver constants(model_.system, components_, result_.unit, diagnostics_);
        for (const SetConstant& setting : claim.constants) {
            if (checked.assumption)
                refuse(setting.name.span,
                       "an assumption restricts inputs, for claims with any constants; a claim sets constants");
            constants.add(setting, named_component(setting.component, file, checked.component.path), checked);
        }
    }

    /// Returns the condition of `possible in S`, where S is a state and not an event.
    static ExprPtr state_of_possible(const Body& body, const CheckedClaim& claim, const FactResolver& facts) {
        if (body.kind != BodyKind::possible || body.events.patterns.size() != 1) return nullptr;
        const Pattern& pattern = body.events.patterns.front();
        const bool plain = pattern.kind == PatternKind::named && pattern.direction == Direction::input &&
                           !pattern.arguments && !pattern.condition;
        const auto& channels = claim.component.channels;
        if (!plain || std::ranges::find(channels, pattern.name.text, &Channel::name) != channels.end() ||
            !facts.has_state(pattern.name.text))
            return nullptr;
        return std::make_shared<const Expr>(Expr{Op::in_state, pattern.name.text, {}, pattern.name.span});
    }

    std::int64_t count_units(const Duration& duration) {
        const durations::UnitCount count = units_of(duration, result_.unit);
        if (count.error.empty()) return count.units;
        diagnostics_.report(rules::wrong_duration, duration.span, {count.error});
        throw ClaimError{};
    }

    [[noreturn]] void says_nothing(Span span, std::string why) {
        diagnostics_.report(rules::says_nothing, span, {std::move(why)});
        throw ClaimError{};
    }

    [[noreturn]] void refuse(Span span, std::string text) {
        diagnostics_.report(rules::wrong_form, span, {std::move(text)});
        throw ClaimError{};
    }

    /// Checks that `can take E` is about one input of a machine, always or while the machine is in one state.
    void check_readiness(const Claim& claim, const CheckedClaim& checked) {
        if (checked.component.kind != ir::ComponentKind::machine)
            refuse(claim.name.span, "`can take` is about one machine: write `of MACHINE`");
        const std::vector<EventMatch>& events = checked.body.events.any;
        const bool one = events.size() == 1 && !events[0].condition && events[0].channels.size() == 1 &&
                         checked.component.channels[events[0].channels[0]].kind == ChannelKind::input;
        if (!one) refuse(claim.body.events.span, "`can take` is about one input, with any value");
        const std::optional<Condition>& condition = checked.scope.condition;
        const bool state = condition && condition->operand == Operand::fact && checked.facts[condition->index].state;
        if (claim.scope.kind != ScopeKind::whole && !state)
            refuse(claim.scope.span, "the scope of `can take` is `while in STATE`");
    }

    void check_scope_of_cycle(const CheckedClaim& checked) {
        if (checked.scope.kind != ScopeKind::cycle) return;
        for (const EventMatch& match : checked.scope.first.any)
            for (const std::size_t channel : match.channels)
                if (checked.component.channels[channel].kind != ChannelKind::input)
                    refuse(match.span, "a cycle begins with inputs: `in a cycle with estop`");
    }

    /// Checks a claim about control cycles. Such a claim observes the inputs that are raised, but not the events that a
    /// machine takes. It may contain durations unless its scope is a single cycle.
    void check_cycle(const Claim& claim, const CheckedClaim& checked) {
        const bool alone = checked.scope.kind == ScopeKind::cycle;
        if (alone && claim.body.duration) refuse(claim.body.duration->span, "a cycle has no time inside");
        if (checked.body.kind == BodyKind::possible || checked.body.kind == BodyKind::leads)
            refuse(claim.body.span, "claims about cycles have a finite run that breaks them");
        const bool facts = checked.scope.kind == ScopeKind::during || (checked.body.condition && !alone);
        if (facts)
            refuse(claim.span,
                   "a claim about cycles reads states at the end of a cycle: `in a cycle with E, always P`");
        for (const Fact& fact : checked.facts)
            if (!fact.state) refuse(claim.body.span, "a claim about cycles reads states, not variables");
        require_raised(claim.scope.first, alone);
        for (const EventSet* events :
             {&claim.scope.last, &claim.body.events, &claim.body.others, &claim.body.exceptions})
            require_raised(*events, false);
    }
    /// Reports events that are not raised events. `whole` is true for the event of the scope `in a cycle with E`, which
    /// is a raised event without the word `raised`.
    void require_raised(const EventSet& events, bool whole) {
        for (const Pattern& pattern : events.patterns) {
            if (pattern.kind == PatternKind::enter || pattern.kind == PatternKind::leave)
                refuse(pattern.span, "a claim about cycles reads states at the end of a cycle: `always in S`");
            if (pattern.kind != PatternKind::named || whole || pattern.direction == Direction::raised) continue;
            if (inputs_.contains(pattern.name.text) && pattern.direction != Direction::output)
                refuse(pattern.span, fmt::format("in cycles, inputs are raised: write `raised {}`", pattern.name.text));
        }
    }

    /// Checks an assumption, which may restrict only what the environment decides, that is, when inputs occur.
    void check_assumption(const Claim& claim, const CheckedClaim& checked) {
        const CheckedBody& body = checked.body;
        if (body.kind == BodyKind::possible || body.kind == BodyKind::leads || !checked.facts.empty())
            refuse(claim.body.span,
                   "an assumption restricts when inputs come: `E leads to F within D`, `never E`, `at most N "
                   "E`");
        const bool response = body.kind == BodyKind::leads_within;
        require_inputs(response ? body.others : body.events, response ? claim.body.others.span : claim.body.events.span,
                       checked);
        if (body.kind == BodyKind::leads_before) require_inputs(body.exceptions, claim.body.exceptions.span, checked);
    }
    void require_inputs(const Events& events, Span span, const CheckedClaim& checked) {
        const bool inputs = !events.terminate && std::ranges::all_of(events.any, [&](const EventMatch& match) {
            return std::ranges::all_of(match.channels, [&](std::size_t channel) {
                return checked.component.channels[channel].kind == ChannelKind::input;
            });
        });
        if (!inputs) refuse(span, "an assumption restricts inputs; outputs and calls are what the component does");
    }

    void check_meaning(const Claim& claim, const CheckedClaim& checked) {
        const CheckedBody& body = checked.body;
        if (body.kind == BodyKind::can_take) check_readiness(claim, checked);
        if (checked.assumption) check_assumption(claim, checked);
        if (checked.component.robosim && !checked.raised)
            refuse(claim.name.span,
                   fmt::format("{} is written in RoboSim: claims about it are about cycles (`in a cycle with E, ...`, "
                               "`raised E`), and `conform` decides them; a .rsa file can state others",
                               checked.component.path));
        if (checked.raised) check_cycle(claim, checked);
        const bool counts = body.kind == BodyKind::at_most || body.kind == BodyKind::every;
        if (counts && claim.scope.kind == ScopeKind::after && !claim.scope.only_first)
            ask_first_or_each(claim, checked);
        check_count(claim, body);
        check_sets(claim, checked);
    }

    void ask_first_or_each(const Claim& claim, const CheckedClaim& checked) {
        auto& finding = diagnostics_.report(rules::first_or_each, claim.scope.span, {checked.scope.first.text});
        const Span at{claim.scope.first.span.source, claim.scope.first.span.begin, claim.scope.first.span.begin};
        finding.fixes.push_back({at, "each ", "anew at each"});
        finding.fixes.push_back({at, "first ", "once, at the first"});
        throw ClaimError{};
    }

    void check_count(const Claim& claim, const CheckedBody& body) {
        if (body.kind == BodyKind::at_most && body.count == 0)
            says_nothing(claim.body.count_span, "write `never` for `at most 0`");
        constexpr std::int64_t most = 1000;
        if (body.count > most) {
            diagnostics_.report(rules::wrong_duration, claim.body.count_span,
                                {fmt::format("at most {} events are counted", most)});
            throw ClaimError{};
        }
        if (body.kind == BodyKind::for_at_least && body.units == 0)
            says_nothing(claim.body.duration->span, "every stay lasts at least 0 time units");
        if (body.kind == BodyKind::at_least && body.units == 0)
            says_nothing(claim.body.duration->span, "every event comes at least 0 time units after another");
    }

    void check_sets(const Claim& claim, const CheckedClaim& checked) {
        const CheckedBody& body = checked.body;
        if (checked.scope.kind == ScopeKind::before && checked.scope.first.start)
            says_nothing(claim.scope.span, "nothing comes before the start");
        if (body.kind == BodyKind::only_after && body.events.text == body.others.text)
            says_nothing(claim.body.span, "both events are the same");
        if (body.kind == BodyKind::leads_before && !body.exceptions.empty() && is_within(body.exceptions, body.others))
            says_nothing(claim.body.exceptions.span, "the answer is also the event before which it has to come");
        const bool ends = checked.scope.kind == ScopeKind::before || checked.scope.kind == ScopeKind::after_each ||
                          checked.scope.kind == ScopeKind::after_until;
        if (!ends || body.kind != BodyKind::never) return;
        const Events& end = checked.scope.kind == ScopeKind::after_until ? checked.scope.last : checked.scope.first;
        if (is_within(body.events, end))
            says_nothing(claim.body.events.span,
                         "what is forbidden ends the scope, and a scope ends before its last event; `last E` compares "
                         "with the value before");
    }

    const ClaimedModel& model_;
    const diagnostics::SourceManager& sources_;
    diagnostics::Diagnostics& diagnostics_;
    std::vector<Component> components_;
    CheckedClaims result_;
    std::set<std::string> inputs_;  ///< inputs of the claim's component
    /// Unconnected events that have been reported: component, machine, event.
    std::set<std::tuple<std::string, std::string, std::string>> reported_;
};

}  // namespace

CheckedClaims check_claims(const std::vector<std::shared_ptr<const ClaimFile>>& files, const ClaimedModel& model,
                           const diagnostics::SourceManager& sources, diagnostics::Diagnostics& diagnostics) {
    return Checker(model, sources, diagnostics).check(files);
}

}  // namespace robochart::claims
