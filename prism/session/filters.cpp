// SPDX-License-Identifier: Apache-2.0
// Evaluates filters, and summarises the results of properties without a filter. See evaluator.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "prism/explore/rules.hpp"
#include "prism/session/evaluator.hpp"

namespace robochart::prism {
namespace {

/// Returns the least and the greatest number in a set of states.
std::pair<Real, Real> least_and_greatest(const StateVector& values, const markov::StateSet& states) {
    std::optional<std::pair<Real, Real>> result;
    for (std::size_t i = 0; i < states.size(); ++i) {
        if (!states[i]) continue;
        const Real value = values.number(i);
        result = result ? std::pair(extreme_of(result->first, value, true), extreme_of(result->second, value, false))
                        : std::pair(value, value);
    }
    return *result;
}

std::string value_text(const StateVector& values, std::size_t state) {
    if (values.undefined_in(state)) return "no value";
    if (values.type != Type::boolean) return values.number(state).text();
    const Truth truth = values.truths[state];
    if (truth == Truth::unknown) return "unknown";
    return truth == Truth::yes ? "true" : "false";
}

std::size_t count_states(const markov::StateSet& states) {
    return static_cast<std::size_t>(std::ranges::count(states, true));
}

}  // namespace

/// Summarises the values of some states. Booleans give the conjunction over all these states; numbers give the value or
/// the range.
Result Evaluator::summarise_values(const StateVector& values, const StateSet& states) const {
    Result result;
    result.type = values.type;
    result.reason = values.reason;
    if (values.type != Type::boolean) {
        const auto [least, most] = least_and_greatest(values, states);
        result.kind = count_states(states) == 1 ? Result::Kind::number : Result::Kind::range;
        result.low = least;
        result.high = most;
        return result;
    }
    Truth all = Truth::yes;
    for (std::size_t i = 0; i < states.size(); ++i) {
        if (!states[i]) continue;
        all = conjunction_of(all, values.truths[i]);
        if (values.truths[i] == Truth::no && result.where.empty())
            result.where = space_.state_text(static_cast<markov::State>(i));
    }
    if (all == Truth::unknown) return result;
    if (all == Truth::undefined)
        for (std::size_t i = 0; i < states.size(); ++i)
            if (states[i]) values.require_value(i);
    result.kind = Result::Kind::truth;
    result.truth = all == Truth::yes;
    result.reason.clear();
    return result;
}

Result Evaluator::answer_question(const ExprPtr& expr) {
    try {
        if (expr->op == Op::filter) return filter_result(*expr);
        return summarise_values(evaluate(expr), initial_state_set());
    } catch (const NoValue& missing) {
        throw_missing_value(missing);
    }
}

namespace {

/// Returns the states with the least or the greatest value. If enclosures overlap, a state is unknown, unless no other
/// state can have the extreme value.
StateVector at_extreme(const StateVector& values, const markov::StateSet& states, bool least) {
    const auto [low, high] = least_and_greatest(values, states);
    const Real& extreme = least ? low : high;
    StateVector result;
    for (std::size_t i = 0; i < states.size(); ++i)
        result.truths.push_back(states[i] ? apply_relation(values.number(i), Op::equal, extreme) : Truth::no);
    if (std::ranges::count(result.truths, Truth::no) + 1 == std::ssize(result.truths))
        std::ranges::replace(result.truths, Truth::unknown, Truth::yes);
    result.reason = fmt::format("which states have the {} value is not known", least ? "least" : "greatest");
    return result;
}

bool asks_for_states(const Expr& filter) {
    return filter.text == "argmin" || filter.text == "argmax";
}

}  // namespace

/// Evaluates argmin and argmax.
Result Evaluator::extreme_states(const Expr& expr) {
    const StateSet states = expr.parts.size() > 1 ? states_satisfying(expr.parts[1]) : StateSet(chain_.states(), true);
    if (count_states(states) == 0) throw Undecided("no state satisfies the filter");
    const StateVector values = evaluate(expr.parts[0]);
    const StateVector found = at_extreme(values, states, expr.text == "argmin");
    Result result;
    result.type = values.type;
    result.reason = found.reason;
    if (std::ranges::find(found.truths, Truth::unknown) != found.truths.end()) return result;
    result.kind = Result::Kind::states;
    result.reason.clear();
    for (std::size_t i = 0; i < states.size(); ++i)
        if (found.truths[i] == Truth::yes)
            result.printed.emplace_back(space_.state_text(static_cast<markov::State>(i)), value_text(values, i));
    return result;
}

/// Evaluates a filter inside an expression. Its value is the same in all states.
StateVector Evaluator::evaluate_filter(const Expr& expr) {
    if (asks_for_states(expr)) {
        const StateSet states =
            expr.parts.size() > 1 ? states_satisfying(expr.parts[1]) : StateSet(chain_.states(), true);
        if (count_states(states) == 0) throw Undecided("no state satisfies the filter");
        return at_extreme(evaluate(expr.parts[0]), states, expr.text == "argmin");
    }
    const Result result = filter_result(expr);
    if (result.kind == Result::Kind::unknown) throw Undecided(result.reason);
    if (result.kind == Result::Kind::range) throw Undecided("an expression contains a range of values");
    StateVector everywhere;
    everywhere.type = result.type;
    everywhere.reason = result.reason;
    if (result.kind == Result::Kind::truth)
        everywhere.truths.assign(chain_.states(), result.truth ? Truth::yes : Truth::no);
    else
        everywhere.reals.assign(chain_.states(), result.low);
    return everywhere;
}

Result Evaluator::filter_result(const Expr& expr) {
    const std::string& kind = expr.text;
    if (asks_for_states(expr)) return extreme_states(expr);
    const StateVector values = evaluate(expr.parts[0]);
    const StateSet states = expr.parts.size() > 1 ? states_satisfying(expr.parts[1]) : StateSet(chain_.states(), true);
    const bool logical = kind == "forall" || kind == "&" || kind == "exists" || kind == "|" || kind == "count";
    if (!logical && count_states(states) == 0) throw Undecided("no state satisfies the filter");
    Result result;
    result.type = values.type;
    result.reason = values.reason;
    const auto number = [&](Real value) {
        result.kind = Result::Kind::number;
        result.low = result.high = std::move(value);
        return result;
    };
    if (kind == "print" || kind == "printall") {
        Result all = summarise_values(values, initial_state_set());
        for (std::size_t i = 0; i < states.size(); ++i) {
            const bool zero = !values.undefined_in(i) &&
                              (values.type == Type::boolean ? values.truths[i] == Truth::no
                                                            : values.number(i).compare(Real(std::int64_t{0})) == 0);
            if (states[i] && (kind == "printall" || !zero))
                all.printed.emplace_back(space_.state_text(static_cast<markov::State>(i)), value_text(values, i));
        }
        return all;
    }
    if (kind == "count") {
        std::int64_t least = 0;
        std::int64_t most = 0;
        for (std::size_t i = 0; i < states.size(); ++i) {
            if (states[i]) values.require_value(i);
            if (states[i] && values.truths[i] == Truth::yes) ++least;
            if (states[i] && values.truths[i] != Truth::no) ++most;
        }
        if (least != most) return result;
        result.type = Type::integer;
        result.reason.clear();
        return number(Real(least));
    }
    if (kind == "exists" || kind == "|") {
        StateVector not_so = values;
        for (Truth& truth : not_so.truths) truth = negation_of(truth);
        Result none = summarise_values(not_so, states);
        none.truth = !none.truth;
        none.where.clear();
        return none;
    }
    if (kind == "forall" || kind == "&") return summarise_values(values, states);
    if (kind == "first" || kind == "state") {
        if (kind == "state" && count_states(states) != 1)
            throw Undecided(fmt::format("the filter needs one state, but {} satisfy it", count_states(states)));
        StateSet first(states.size());
        first[static_cast<std::size_t>(std::ranges::find(states, true) - states.begin())] = true;
        return summarise_values(values, first);
    }
    if (kind == "sum" || kind == "+" || kind == "avg") {
        Real sum;
        try {
            for (std::size_t i = 0; i < states.size(); ++i)
                if (states[i]) sum = sum + values.number(i);
        } catch (const Unclear& error) {
            throw Undecided(error.what());
        } catch (const std::domain_error& error) {
            throw EvaluationError(rules::arithmetic, expr.span, {error.what()});
        }
        return number(kind == "avg" ? sum / Real(static_cast<std::int64_t>(count_states(states))) : sum);
    }
    const auto [least, most] = least_and_greatest(values, states);
    if (kind == "min") return number(least);
    if (kind == "max") return number(most);
    result.kind = Result::Kind::range;
    result.low = least;
    result.high = most;
    return result;
}

}  // namespace robochart::prism
