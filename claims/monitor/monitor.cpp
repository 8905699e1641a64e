// SPDX-License-Identifier: Apache-2.0
// See monitor.hpp. The rules are those of docs/claims.md, "Meaning".
#include "claims/monitor/monitor.hpp"

#include <algorithm>

namespace robochart::claims {
namespace {

/// The values of the operands of a condition.
struct Operands {
    const std::vector<Fraction>& arguments;
    const std::vector<std::optional<Fraction>>& last;
    const std::vector<std::optional<bool>>& facts;
};

Fraction truth(bool value) {
    return Fraction(value ? 1 : 0);
}

/// Returns the remainder of whole numbers, which is at least 0.
Fraction remainder(const Fraction& number, const Fraction& by) {
    if (!number.is_whole() || !by.is_whole() || by <= Fraction(0))
        throw NotComputable("`%` divides a whole number by a whole number above 0");
    const std::int64_t rest = number.numerator() % by.numerator();
    return Fraction(rest < 0 ? rest + by.numerator() : rest);
}

/// Evaluates a condition. Returns no value if the condition uses a last value that does not exist, or an unknown fact.
std::optional<Fraction> evaluate(const Condition& condition, const Operands& operands);

std::optional<Fraction> evaluate_operator(const Condition& condition, const Operands& operands) {
    std::vector<Fraction> parts;
    for (const Condition& part : condition.parts) {
        const std::optional<Fraction> value = evaluate(part, operands);
        if (!value) return std::nullopt;
        parts.push_back(*value);
    }
    switch (condition.op) {
        case Op::number:
        case Op::truth:
        case Op::name:
        case Op::last:
        case Op::in_state:
            return std::nullopt;  // an operand
        case Op::negate:
            return Fraction(-1) * parts[0];
        case Op::add:
            return parts[0] + parts[1];
        case Op::subtract:
            return parts[0] - parts[1];
        case Op::multiply:
            return parts[0] * parts[1];
        case Op::modulus:
            return remainder(parts[0], parts[1]);
        case Op::less:
            return truth(parts[0] < parts[1]);
        case Op::less_equal:
            return truth(parts[0] <= parts[1]);
        case Op::greater:
            return truth(parts[0] > parts[1]);
        case Op::greater_equal:
            return truth(parts[0] >= parts[1]);
        case Op::equal:
            return truth(parts[0] == parts[1]);
        case Op::unequal:
            return truth(parts[0] != parts[1]);
        case Op::negation:
            return truth(parts[0] == Fraction(0));
        case Op::conjunction:
            return truth(std::ranges::none_of(parts, [](const Fraction& part) { return part == Fraction(0); }));
        case Op::disjunction:
            return truth(std::ranges::any_of(parts, [](const Fraction& part) { return part != Fraction(0); }));
    }
    return std::nullopt;
}

std::optional<Fraction> evaluate(const Condition& condition, const Operands& operands) {
    switch (condition.operand) {
        case Operand::none:
            return evaluate_operator(condition, operands);
        case Operand::constant:
            return condition.value;
        case Operand::argument:
            return operands.arguments.at(condition.index);
        case Operand::last:
            return operands.last.at(condition.index);
        case Operand::fact: {
            const std::optional<bool> holds = operands.facts.at(condition.index);
            return holds ? std::optional(truth(*holds)) : std::nullopt;
        }
        case Operand::variable:
        case Operand::of_model:
            break;  // occurs only in the condition of a fact
    }
    return std::nullopt;
}

/// Evaluates a condition on facts; an unknown fact makes the condition false.
bool holds(const std::optional<Condition>& condition, const MonitorState& state) {
    if (!condition) return false;
    const std::vector<Fraction> no_arguments;
    const std::optional<Fraction> value = evaluate(*condition, {no_arguments, state.last, state.facts});
    return value && *value != Fraction(0);
}

bool reads_fact(const std::optional<Condition>& condition, std::size_t fact);

bool reads_fact(const Condition& condition, std::size_t fact) {
    if (condition.operand == Operand::fact) return condition.index == fact;
    return std::ranges::any_of(condition.parts, [&](const Condition& part) { return reads_fact(part, fact); });
}

bool reads_fact(const std::optional<Condition>& condition, std::size_t fact) {
    return condition && reads_fact(*condition, fact);
}

bool is_of_stay(BodyKind kind) {
    return kind == BodyKind::for_at_least || kind == BodyKind::for_at_most;
}

}  // namespace

bool Monitor::matches(const Events& events, const Occurrence& event, const MonitorState& state) {
    return std::ranges::any_of(events.any, [&](const EventMatch& match) {
        if (!std::ranges::binary_search(match.channels, event.channel)) return false;
        if (!match.condition) return true;
        const std::optional<Fraction> holds = evaluate(*match.condition, {event.values, state.last, state.facts});
        return holds && *holds != Fraction(0);
    });
}

bool Monitor::matches(const Events& events, const Seen& seen, const MonitorState& state) {
    if (seen.event != nullptr) return matches(events, *seen.event, state);
    if (seen.change != Change::none)
        return std::ranges::any_of(events.any, [&](const EventMatch& match) {
            return match.change == seen.change && match.fact == seen.fact;
        });
    return (seen.start && events.start) || (seen.terminate && events.terminate);
}

// ---------------------------------------------------------------- the scope

MonitorState Monitor::begin() const {
    MonitorState state;
    state.last.resize(claim_.remembered.size());
    state.facts.resize(claim_.facts.size());
    if (claim_.scope.kind == ScopeKind::whole || claim_.scope.kind == ScopeKind::before) enter(state);
    observe(state, Seen{.start = true});
    return state;
}

/// Begins the scope.
void Monitor::enter(MonitorState& state) const {
    leave(state, Phase::inside);
    state.scope_left = claim_.scope.units;
    if (claim_.body.kind == BodyKind::every) state.left = claim_.body.units.value();
}

/// Ends the scope, so that nothing is pending any more.
void Monitor::leave(MonitorState& state, Phase phase) const {
    MonitorState next;
    next.verdict = state.verdict;
    next.phase = phase;
    next.last = std::move(state.last);
    next.facts = std::move(state.facts);
    next.stay = state.stay;
    state = std::move(next);
}

void Monitor::observe(MonitorState& state, const Occurrence& event) const {
    if (state.verdict != Verdict::open) return;
    observe(state, Seen{.event = &event});
    for (std::size_t i = 0; i < claim_.remembered.size(); ++i)
        if (claim_.remembered[i] == event.channel) state.last[i] = event.values.at(0);
}

/// Observes an event. A scope begins after its first event and ends before its last event. One event may end a scope
/// and begin the next. `for D after E` ends D time units after the last E, which belongs to the scope.
void Monitor::observe(MonitorState& state, const Seen& seen) const {
    const CheckedScope& scope = claim_.scope;
    const bool first = matches(scope.first, seen, state);
    switch (scope.kind) {
        case ScopeKind::whole:
        case ScopeKind::during:
            break;
        case ScopeKind::before:
            if (first && state.phase == Phase::inside) return leave(state, Phase::over);
            break;
        case ScopeKind::after:
            if (first && state.phase == Phase::outside) return enter(state);
            break;
        case ScopeKind::after_until: {
            const bool ends = state.phase == Phase::inside && matches(scope.last, seen, state);
            if (first && (ends || state.phase == Phase::outside)) return enter(state);
            if (ends) return leave(state, Phase::outside);
            break;
        }
        case ScopeKind::after_each:
            if (!first) break;
            enter(state);
            // An event that begins a scope, and is counted, is counted in the scope that it begins.
            if (claim_.body.kind == BodyKind::at_most && matches(claim_.body.events, seen, state)) count(state);
            return;
        case ScopeKind::for_after:
            if (first && state.phase == Phase::outside) return enter(state);
            break;
        case ScopeKind::cycle:
            if (first && state.phase == Phase::outside) enter(state);
            break;
    }
    if (state.phase != Phase::inside) return;
    observe_in_scope(state, seen);
    if (first && scope.kind == ScopeKind::for_after) state.scope_left = scope.units;
}

std::vector<Occurrence> Monitor::order_raised(const MonitorState& state, std::vector<Occurrence> raised) const {
    const CheckedScope& scope = claim_.scope;
    const auto rank = [&](const Occurrence& event) {
        if (scope.kind == ScopeKind::cycle && matches(scope.first, event, state)) return 0;
        if (matches(scope.last, event, state)) return 1;
        if (scope.kind == ScopeKind::before && matches(scope.first, event, state)) return 1;
        if (serves(state, event)) return 2;
        return matches(scope.first, event, state) ? 3 : 4;
    };
    std::ranges::stable_sort(raised, {}, rank);
    return raised;
}

void Monitor::tock(MonitorState& state) const {
    if (state.verdict != Verdict::open) return;
    if (state.phase == Phase::inside && claim_.scope.kind == ScopeKind::for_after) {
        if (state.scope_left == 0)
            leave(state, Phase::outside);
        else
            --state.scope_left;
    }
    if (state.phase == Phase::inside) pass_in_scope(state);
    if (claim_.scope.kind == ScopeKind::cycle && state.verdict == Verdict::open) leave(state, Phase::outside);
    if (state.stay > 0) --state.stay;
}

/// Observes the end of the component. It is never forbidden, but it breaks the claim if a response is pending.
void Monitor::end(MonitorState& state) const {
    if (state.verdict != Verdict::open) return;
    observe(state, Seen{.terminate = true});
    if (owes(state) && !is_of_stay(claim_.body.kind)) state.verdict = Verdict::broken;
}

bool Monitor::owes(const MonitorState& state) const {
    if (state.verdict != Verdict::open || state.phase != Phase::inside) return false;
    const BodyKind kind = claim_.body.kind;
    return kind == BodyKind::every || (kind == BodyKind::leads_within && state.left >= 0) ||
           (kind == BodyKind::leads && state.due) || (kind == BodyKind::for_at_most && state.stay >= 0);
}

bool Monitor::judges_facts(const MonitorState& state) const {
    if (state.verdict != Verdict::open || state.phase != Phase::inside) return false;
    return claim_.body.kind == BodyKind::always || (is_of_stay(claim_.body.kind) && state.stay >= 0);
}

// ---------------------------------------------------------------- states and variables

/// Observes the facts in this order: states are left, the scope of `while` ends or begins, states are entered. A change
/// that ends the scope is observed after the end, and a change that begins the scope before the beginning. So neither
/// change is inside the scope.
void Monitor::observe(MonitorState& state, const std::vector<FactValue>& values) const {
    if (state.verdict != Verdict::open) return;
    const bool inside = state.phase == Phase::inside;
    const bool scope = holds(claim_.scope.condition, state), body = holds(claim_.body.condition, state);
    std::vector<Seen> of_scope[2], others[2];
    for (const FactValue& value : values) {
        const std::optional<Seen> change = change_of(state, value);
        state.facts.at(value.fact) = value.holds;
        auto& list = reads_fact(claim_.scope.condition, value.fact) ? of_scope : others;
        if (change) list[value.holds ? 1 : 0].push_back(*change);
    }
    const auto observe_all = [&](const std::vector<Seen>& list) {
        for (const Seen& seen : list)
            if (state.verdict == Verdict::open) observe(state, seen);
    };
    const bool within = holds(claim_.scope.condition, state);
    observe_all(others[0]);
    if (scope && !within && state.verdict == Verdict::open) leave(state, Phase::outside);
    observe_all(of_scope[0]);
    observe_all(of_scope[1]);
    if (!scope && within && state.verdict == Verdict::open) enter(state);
    observe_all(others[1]);
    if (state.verdict == Verdict::open) follow_condition(state, body, inside);
}

/// Returns the change of a fact. A fact that is not known yet is treated as false.
std::optional<Monitor::Seen> Monitor::change_of(const MonitorState& state, const FactValue& value) {
    if (state.facts.at(value.fact).value_or(false) == value.holds) return std::nullopt;
    Seen seen;
    seen.change = value.holds ? Change::begins : Change::ends;
    seen.fact = value.fact;
    return seen;
}

bool Monitor::serves(const MonitorState& state, const Occurrence& event) const {
    return matches(claim_.body.others, event, state) || matches(claim_.body.exceptions, event, state);
}

bool Monitor::serves(const MonitorState& state, const std::vector<FactValue>& values) const {
    return std::ranges::any_of(values, [&](const FactValue& value) {
        const std::optional<Seen> change = change_of(state, value);
        return change &&
               (matches(claim_.body.others, *change, state) || matches(claim_.body.exceptions, *change, state));
    });
}

/// Updates the state if the body's condition begins to hold, continues to hold, or ceases to hold. `before` is its
/// previous value; `inside` is true if the scope had begun before.
void Monitor::follow_condition(MonitorState& state, bool before, bool inside) const {
    const bool now = holds(claim_.body.condition, state);
    if (claim_.body.kind == BodyKind::possible && now && state.phase == Phase::inside)
        state.verdict = Verdict::satisfied;
    if (!is_of_stay(claim_.body.kind) || before == now) return;
    const bool judged = inside && state.phase == Phase::inside && claim_.body.kind == BodyKind::for_at_least;
    if (before && judged && state.stay > 0) state.verdict = Verdict::broken;
    state.stay = now ? claim_.body.units.value() : -1;
}

// ---------------------------------------------------------------- the body

void Monitor::observe_in_scope(MonitorState& state, const Seen& seen) const {
    const CheckedBody& body = claim_.body;
    const auto is_in = [&](const Events& events) { return matches(events, seen, state); };
    switch (body.kind) {
        case BodyKind::never:
            if (is_in(body.events)) state.verdict = Verdict::broken;
            return;
        case BodyKind::only_after:
            if (state.due) return;
            if (is_in(body.events))
                state.verdict = Verdict::broken;
            else
                state.due = is_in(body.others);
            return;
        case BodyKind::only_within:
            if (is_in(body.events) && state.left < 0) state.verdict = Verdict::broken;
            if (is_in(body.others)) state.left = body.units.value();
            return;
        case BodyKind::leads_within:
        case BodyKind::leads:
        case BodyKind::leads_before:
            return observe_response(state, seen);
        case BodyKind::at_least:
            return observe_delay(state, seen);
        case BodyKind::at_most:
            if (is_in(body.events)) count(state);
            return;
        case BodyKind::every:
            if (is_in(body.events)) state.left = body.units.value();
            return;
        case BodyKind::possible:
            if (is_in(body.events)) state.verdict = Verdict::satisfied;
            return;
        case BodyKind::always:
        case BodyKind::for_at_least:
        case BodyKind::for_at_most:
        case BodyKind::can_take:
            return;
    }
}

/// Observes an event for `leads to`. One response answers all open triggers, and the oldest of them determines the time
/// limit. An event that is both a response and a trigger answers the earlier triggers and is itself a new trigger.
void Monitor::observe_response(MonitorState& state, const Seen& seen) const {
    const CheckedBody& body = claim_.body;
    const bool timed = body.kind == BodyKind::leads_within;
    const bool owed = timed ? state.left >= 0 : state.due;
    const bool other = matches(body.exceptions, seen, state);
    const bool served = matches(body.others, seen, state) || (other && body.kind != BodyKind::leads_before);
    if (owed && !served) {
        if (other) state.verdict = Verdict::broken;
        return;
    }
    const bool opens = matches(body.events, seen, state);
    if (!timed)
        state.due = opens;
    else
        state.left = opens ? body.units.value() : -1;
}

/// Observes an event for a delay, which is counted from the latest occurrence of OTHERS. An exception ends the delay
/// before the event is checked.
void Monitor::observe_delay(MonitorState& state, const Seen& seen) const {
    const CheckedBody& body = claim_.body;
    if (matches(body.exceptions, seen, state)) state.left = -1;
    if (state.left >= 0 && matches(body.events, seen, state)) state.verdict = Verdict::broken;
    if (matches(body.others, seen, state)) state.left = body.units.value() - 1;
}

void Monitor::count(MonitorState& state) const {
    const CheckedBody& body = claim_.body;
    const std::int64_t before = body.units ? std::ssize(state.ages) : state.count;
    if (before == body.count)
        state.verdict = Verdict::broken;
    else if (body.units)
        state.ages.insert(state.ages.begin(), 0);
    else
        ++state.count;
}

void Monitor::pass_in_scope(MonitorState& state) const {
    const BodyKind kind = claim_.body.kind;
    if (kind == BodyKind::at_most && claim_.body.units) {
        std::erase_if(state.ages, [&](std::int64_t age) { return age >= *claim_.body.units; });
        for (std::int64_t& age : state.ages) ++age;
    }
    const bool stays_too_long = kind == BodyKind::for_at_most && state.stay == 0;
    if (stays_too_long || (kind == BodyKind::always && !holds(claim_.body.condition, state)))
        state.verdict = Verdict::broken;
    if (state.left < 0) return;
    const bool owed = kind == BodyKind::leads_within || kind == BodyKind::every;
    if (state.left == 0 && owed) state.verdict = Verdict::broken;
    --state.left;
}

}  // namespace robochart::claims
