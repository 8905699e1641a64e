// SPDX-License-Identifier: Apache-2.0
// See monitor.hpp. The rules are those of docs/claims.md, "Meaning".
#include "claims/monitor/monitor.hpp"

#include <algorithm>

namespace robochart::claims {
namespace {

using Values = std::vector<std::optional<Fraction>>;

Fraction truth(bool value) {
    return Fraction(value ? 1 : 0);
}

/// The remainder of whole numbers, at least 0.
Fraction remainder(const Fraction& number, const Fraction& by) {
    if (!number.is_whole() || !by.is_whole() || by <= Fraction(0))
        throw NotComputable("`%` divides a whole number by a whole number above 0");
    const std::int64_t rest = number.numerator() % by.numerator();
    return Fraction(rest < 0 ? rest + by.numerator() : rest);
}

/// No value if it uses a last value that does not exist.
std::optional<Fraction> evaluate(const Condition& condition, const std::vector<Fraction>& arguments,
                                 const Values& last);

std::optional<Fraction> evaluate_operator(const Condition& condition, const std::vector<Fraction>& arguments,
                                          const Values& last) {
    std::vector<Fraction> parts;
    for (const Condition& part : condition.parts) {
        const std::optional<Fraction> value = evaluate(part, arguments, last);
        if (!value) return std::nullopt;
        parts.push_back(*value);
    }
    switch (condition.op) {
        case Op::number:
        case Op::truth:
        case Op::name:
        case Op::last:
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

std::optional<Fraction> evaluate(const Condition& condition, const std::vector<Fraction>& arguments,
                                 const Values& last) {
    switch (condition.operand) {
        case Operand::none:
            return evaluate_operator(condition, arguments, last);
        case Operand::constant:
            return condition.value;
        case Operand::argument:
            return arguments.at(condition.index);
        case Operand::last:
            return last.at(condition.index);
    }
    return std::nullopt;
}

}  // namespace

bool Monitor::matches(const Events& events, const Occurrence& event, const MonitorState& state) {
    return std::ranges::any_of(events.any, [&](const EventMatch& match) {
        if (!std::ranges::binary_search(match.channels, event.channel)) return false;
        if (!match.condition) return true;
        const std::optional<Fraction> holds = evaluate(*match.condition, event.values, state.last);
        return holds && *holds != Fraction(0);
    });
}

bool Monitor::matches(const Events& events, const Seen& seen, const MonitorState& state) {
    if (seen.event != nullptr) return matches(events, *seen.event, state);
    return (seen.start && events.start) || (seen.terminate && events.terminate);
}

// ---------------------------------------------------------------- the scope

MonitorState Monitor::begin() const {
    MonitorState state;
    state.last.resize(claim_.remembered.size());
    if (claim_.scope.kind == ScopeKind::whole || claim_.scope.kind == ScopeKind::before) enter(state);
    observe(state, Seen{nullptr, true, false});
    return state;
}

/// The scope begins.
void Monitor::enter(MonitorState& state) const {
    leave(state, Phase::inside);
    state.scope_left = claim_.scope.units;
    if (claim_.body.kind == BodyKind::every) state.left = claim_.body.units.value();
}

/// The scope ends, with everything that is owed in it.
void Monitor::leave(MonitorState& state, Phase phase) const {
    MonitorState next;
    next.verdict = state.verdict;
    next.phase = phase;
    next.last = std::move(state.last);
    state = std::move(next);
}

void Monitor::observe(MonitorState& state, const Occurrence& event) const {
    if (state.verdict != Verdict::open) return;
    observe(state, Seen{&event, false, false});
    for (std::size_t i = 0; i < claim_.remembered.size(); ++i)
        if (claim_.remembered[i] == event.channel) state.last[i] = event.values.at(0);
}

/// A scope begins behind its first event and ends before its last one. If one event does both, it ends one scope and
/// begins the next. `for D after E` ends D time units after the last E, which belongs to the scope.
void Monitor::observe(MonitorState& state, const Seen& seen) const {
    const CheckedScope& scope = claim_.scope;
    const bool first = matches(scope.first, seen, state);
    switch (scope.kind) {
        case ScopeKind::whole:
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
            // An event that is counted and begins a scope counts in the scope that it begins.
            if (claim_.body.kind == BodyKind::at_most && matches(claim_.body.events, seen, state)) count(state);
            return;
        case ScopeKind::for_after:
            if (first && state.phase == Phase::outside) return enter(state);
            break;
    }
    if (state.phase != Phase::inside) return;
    observe_in_scope(state, seen);
    if (first && scope.kind == ScopeKind::for_after) state.scope_left = scope.units;
}

void Monitor::tock(MonitorState& state) const {
    if (state.verdict != Verdict::open || state.phase != Phase::inside) return;
    if (claim_.scope.kind == ScopeKind::for_after) {
        if (state.scope_left == 0) return leave(state, Phase::outside);
        --state.scope_left;
    }
    pass_in_scope(state);
}

/// The end forbids nothing, and breaks what is owed.
void Monitor::end(MonitorState& state) const {
    if (state.verdict != Verdict::open) return;
    observe(state, Seen{nullptr, false, true});
    if (owes(state)) state.verdict = Verdict::broken;
}

bool Monitor::owes(const MonitorState& state) const {
    if (state.verdict != Verdict::open || state.phase != Phase::inside) return false;
    const BodyKind kind = claim_.body.kind;
    return kind == BodyKind::every || (kind == BodyKind::leads_within && state.left >= 0) ||
           (kind == BodyKind::leads && state.due);
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
    }
}

/// One answer serves all open triggers, of which the oldest decides when time is up. An event that is both serves those
/// before it and opens its own.
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

/// The youngest of OTHERS decides. An exception ends the wait before the event is judged.
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
    if (state.left < 0) return;
    const bool owed = kind == BodyKind::leads_within || kind == BodyKind::every;
    if (state.left == 0 && owed) state.verdict = Verdict::broken;
    --state.left;
}

}  // namespace robochart::claims
