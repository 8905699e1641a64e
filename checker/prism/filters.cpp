// Filters, and what a property answers without one. See evaluator.hpp.
#include <fmt/format.h>

#include <algorithm>

#include "checker/prism/evaluator.hpp"

namespace robochart::prism {
namespace {

/// Least and greatest of the numbers in some states, as enclosures.
std::pair<Real, Real> extremes(const StateVector& values, const markov::StateSet& states) {
    std::optional<Enclosure> least, most;
    std::optional<Real> first;
    bool exact = true;
    Real exact_least, exact_most;
    for (std::size_t i = 0; i < states.size(); ++i) {
        if (!states[i]) continue;
        const Real value = values.number(i);
        const Enclosure bounds = value.bounds();
        exact = exact && value.exact();
        if (!least) {
            least = most = bounds;
            exact_least = exact_most = value;
            continue;
        }
        if (exact && value.compare(exact_least) == -1) exact_least = value;
        if (exact && value.compare(exact_most) == 1) exact_most = value;
        least = Enclosure{std::min(least->low, bounds.low), std::min(least->high, bounds.high)};
        most = Enclosure{std::max(most->low, bounds.low), std::max(most->high, bounds.high)};
    }
    if (exact) return {exact_least, exact_most};
    return {Real(*least), Real(*most)};
}

std::string value_text(const StateVector& values, std::size_t state) {
    if (values.type != Type::boolean) return values.number(state).text();
    const Truth truth = values.truths[state];
    return truth == Truth::unknown ? "unknown" : truth == Truth::yes ? "true" : "false";
}

std::size_t count(const markov::StateSet& states) {
    return static_cast<std::size_t>(std::count(states.begin(), states.end(), true));
}

}  // namespace

/// Boolean: all of them; numbers: the one, or the range.
Result Evaluator::over(const StateVector& values, const StateSet& states) const {
    Result result;
    result.type = values.type;
    result.reason = values.reason;
    if (values.type != Type::boolean) {
        const auto [least, most] = extremes(values, states);
        result.kind = count(states) == 1 ? Result::Kind::number : Result::Kind::range;
        result.low = least;
        result.high = most;
        return result;
    }
    Truth all = Truth::yes;
    for (std::size_t i = 0; i < states.size(); ++i) {
        if (!states[i]) continue;
        all = both(all, values.truths[i]);
        if (values.truths[i] == Truth::no && result.where.empty())
            result.where = space_.text(static_cast<markov::State>(i));
    }
    if (all == Truth::unknown) return result;
    result.kind = Result::Kind::truth;
    result.truth = all == Truth::yes;
    result.reason.clear();
    return result;
}

Result Evaluator::answer(const ExprPtr& expr) {
    if (expr->op == Op::filter) return filtered(*expr);
    return over(evaluate(expr), initial());
}

/// In an expression a filter has one value everywhere.
StateVector Evaluator::filter(const Expr& expr) {
    if (expr.text == "argmin" || expr.text == "argmax") {
        const StateSet states = expr.parts.size() > 1 ? set(expr.parts[1]) : StateSet(chain_.states(), true);
        const StateVector values = evaluate(expr.parts[0]);
        const auto [least, most] = extremes(values, states);
        StateVector result;
        for (std::size_t i = 0; i < states.size(); ++i)
            result.truths.push_back(
                states[i] ? related(values.number(i), Op::equal, expr.text == "argmin" ? least : most) : Truth::no);
        result.reason = "the states of the extreme value are not known";
        return result;
    }
    const Result result = filtered(expr);
    if (result.kind == Result::Kind::unknown) throw Undecided(result.reason);
    if (result.kind == Result::Kind::range) throw Undecided("a range of values stands in an expression");
    StateVector everywhere;
    everywhere.type = result.type;
    everywhere.reason = result.reason;
    if (result.kind == Result::Kind::truth)
        everywhere.truths.assign(chain_.states(), result.truth ? Truth::yes : Truth::no);
    else
        everywhere.reals.assign(chain_.states(), result.low);
    return everywhere;
}

Result Evaluator::filtered(const Expr& expr) {
    const std::string& kind = expr.text;
    if (kind == "argmin" || kind == "argmax") return over(filter(expr), initial());
    const StateVector values = evaluate(expr.parts[0]);
    const StateSet states = expr.parts.size() > 1 ? set(expr.parts[1]) : StateSet(chain_.states(), true);
    const bool logical = kind == "forall" || kind == "&" || kind == "exists" || kind == "|" || kind == "count";
    if (!logical && count(states) == 0) throw Undecided("no state satisfies the filter");
    Result result;
    result.type = values.type;
    result.reason = values.reason;
    const auto number = [&](Real value) {
        result.kind = Result::Kind::number;
        result.low = result.high = std::move(value);
        return result;
    };
    if (kind == "print" || kind == "printall") {
        Result all = over(values, initial());
        for (std::size_t i = 0; i < states.size(); ++i) {
            const bool zero = values.type == Type::boolean ? values.truths[i] == Truth::no
                                                           : values.number(i).compare(Real(std::int64_t{0})) == 0;
            if (states[i] && (kind == "printall" || !zero))
                all.printed.emplace_back(space_.text(static_cast<markov::State>(i)), value_text(values, i));
        }
        return all;
    }
    if (kind == "count") {
        std::int64_t least = 0;
        std::int64_t most = 0;
        for (std::size_t i = 0; i < states.size(); ++i) {
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
        for (Truth& each : not_so.truths) each = negated(each);
        Result none = over(not_so, states);
        none.truth = !none.truth;
        none.where.clear();
        return none;
    }
    if (kind == "forall" || kind == "&") return over(values, states);
    if (kind == "first" || kind == "state") {
        if (kind == "state" && count(states) != 1)
            throw Undecided(fmt::format("the filter asks for one state, and {} satisfy it", count(states)));
        StateSet first(states.size());
        first[static_cast<std::size_t>(std::find(states.begin(), states.end(), true) - states.begin())] = true;
        return over(values, first);
    }
    if (kind == "sum" || kind == "+" || kind == "avg") {
        Real sum;
        for (std::size_t i = 0; i < states.size(); ++i)
            if (states[i]) sum = sum + values.number(i);
        return number(kind == "avg" ? sum / Real(static_cast<std::int64_t>(count(states))) : sum);
    }
    const auto [least, most] = extremes(values, states);
    if (kind == "min") return number(least);
    if (kind == "max") return number(most);
    result.kind = Result::Kind::range;
    result.low = least;
    result.high = most;
    return result;
}

}  // namespace robochart::prism
