// SPDX-License-Identifier: Apache-2.0
// See formulas.hpp.
#include "simulation/trial/formulas.hpp"

#include <algorithm>
#include <cmath>

namespace robochart::simulation {

namespace {

using Kind = Formula::Kind;

std::size_t count_stays(const Formula& formula) {
    std::size_t count = formula.kind == Kind::stays ? 1 : 0;
    for (const Formula& part : formula.parts) count += count_stays(part);
    return count;
}

/// Returns the step for a time, or the last step for an infinite time.
std::uint64_t step_at(double time, double control_step, std::uint64_t end) {
    return std::isinf(time) ? end : static_cast<std::uint64_t>(std::llround(time / control_step));
}

}  // namespace

Condition::Condition(const Formula& formula, double control_step)
    : formula_(formula), control_step_(control_step), since_(count_stays(formula), never) {}

bool Condition::holds_after(std::uint64_t step, const MeasureNow& now) {
    std::size_t stay = 0;
    return holds_after(formula_, step, now, stay);
}

/// Evaluates a condition. All parts are evaluated, because a `stays` in them must be updated in every step.
bool Condition::holds_after(const Formula& formula, std::uint64_t step, const MeasureNow& now, std::size_t& stay) {
    if (formula.kind == Kind::compare) {
        const double value = now(formula.measure);
        return formula.low <= value && value <= formula.high;
    }
    const std::size_t own = formula.kind == Kind::stays ? stay++ : 0;
    bool all = true;
    bool any = false;
    for (const Formula& part : formula.parts) {
        const bool one = holds_after(part, step, now, stay);
        all = all && one;
        any = any || one;
    }
    switch (formula.kind) {
        case Kind::negation:
            return !all;
        case Kind::either:
            return any;
        case Kind::stays:
            if (!all)
                since_[own] = never;
            else if (since_[own] == never)
                since_[own] = step;
            return all && step - since_[own] >= step_at(formula.time, control_step_, 0);
        case Kind::compare:
        case Kind::at:
        case Kind::within:
        case Kind::until:
        case Kind::always:
        case Kind::both:
            break;
    }
    return all;
}

Property::Property(const Formula& formula, double control_step, std::uint64_t end) : formula_(formula) {
    collect_timed(formula, control_step, end);
}

void Property::collect_timed(const Formula& formula, double control_step, std::uint64_t end) {
    if (formula.kind == Kind::negation || formula.kind == Kind::both || formula.kind == Kind::either) {
        for (const Formula& part : formula.parts) collect_timed(part, control_step, end);
        return;
    }
    Timed& timed = timed_.emplace_back();
    timed.formula = &formula;
    timed.last = std::min(end, step_at(formula.time, control_step, end));
    for (const Formula& part : formula.parts) timed.parts.emplace_back(part, control_step);
}

bool Property::is_due(std::uint64_t step) const {
    if (answer_.holds) return false;
    return std::ranges::any_of(timed_, [&](const Timed& timed) {
        if (timed.holds) return false;
        // A formula that refers to the past must also be evaluated at earlier steps.
        return timed.formula->kind != Kind::at || step == timed.last || count_stays(*timed.formula) > 0;
    });
}

void Property::evaluate_at(std::uint64_t step, const MeasureNow& now) {
    if (answer_.holds) return;
    for (Timed& timed : timed_)
        if (!timed.holds) evaluate_at(timed, step, now);
    std::size_t timed = 0;
    answer_.holds = known_value(formula_, timed);
    if (answer_.holds) answer_.step = step;
}

/// Evaluates a part that is not decided yet.
void Property::evaluate_at(Timed& timed, std::uint64_t step, const MeasureNow& now) {
    if (timed.formula->kind == Kind::at && step != timed.last && count_stays(*timed.formula) == 0) return;
    const bool first = timed.parts.front().holds_after(step, now);
    const bool last = step >= timed.last;
    switch (timed.formula->kind) {
        case Kind::within:
            if (first || last) timed.holds = first;
            return;
        case Kind::always:
            if (!first || last) timed.holds = first;
            return;
        case Kind::until: {
            const bool reached = timed.parts.back().holds_after(step, now);
            if (reached || !first || last) timed.holds = reached;
            return;
        }
        case Kind::compare:
        case Kind::stays:
        case Kind::at:
        case Kind::negation:
        case Kind::both:
        case Kind::either:
            break;
    }
    if (last) timed.holds = first;
}

/// Returns the value in three-valued logic (Kleene).
std::optional<bool> Property::known_value(const Formula& formula, std::size_t& timed) const {
    if (formula.kind != Kind::negation && formula.kind != Kind::both && formula.kind != Kind::either)
        return timed_[timed++].holds;
    const bool decisive = formula.kind == Kind::either;  // one false part decides `both`
    bool open = false;
    bool decided = false;
    std::optional<bool> only;
    for (const Formula& part : formula.parts) {
        only = known_value(part, timed);
        open = open || !only;
        decided = decided || only == decisive;
    }
    if (formula.kind == Kind::negation) return only ? std::optional(!*only) : std::nullopt;
    if (decided) return decisive;
    return open ? std::nullopt : std::optional(!decisive);
}

void Property::end(std::uint64_t step, bool holds) {
    if (!answer_.holds) answer_ = {holds, step, true};
}

}  // namespace robochart::simulation
