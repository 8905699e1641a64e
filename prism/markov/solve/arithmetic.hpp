// SPDX-License-Identifier: Apache-2.0
// Adapts the operators to their arithmetics: intervals, rationals, and doubles for guesses.
#pragma once

#include <algorithm>
#include <vector>

#include "prism/markov/model/model.hpp"
#include "prism/markov/solve/interval.hpp"
#include "prism/markov/solve/solution.hpp"

namespace robochart::markov {

/// Converts the numbers of a model to another arithmetic. A double may be any value of the enclosure.
[[nodiscard]] std::vector<Interval> convert_numbers(const std::vector<Number>& numbers,
                                                    const std::vector<Rational>& exact, const Interval&);
[[nodiscard]] std::vector<Rational> convert_numbers(const std::vector<Number>& numbers,
                                                    const std::vector<Rational>& exact, const Rational&);

[[nodiscard]] inline Interval best_of(const Interval& left, const Interval& right, Direction direction) {
    Interval result;
    const bool greater = direction == Direction::maximum;
    result.negated_low =
        greater ? std::min(left.negated_low, right.negated_low) : std::max(left.negated_low, right.negated_low);
    result.high = greater ? std::max(left.high, right.high) : std::min(left.high, right.high);
    return result;
}
template <class Value>
[[nodiscard]] Value best_of(const Value& left, const Value& right, Direction direction) {
    return (direction == Direction::maximum) == (left < right) ? right : left;
}

/// Returns whether `left` is strictly better. Intervals are compared by one of their values, because the comparison
/// affects only the choice of a strategy.
[[nodiscard]] inline bool is_better(const Interval& left, const Interval& right, Direction direction) {
    return direction == Direction::maximum ? left.middle() > right.middle() : left.middle() < right.middle();
}
template <class Value>
[[nodiscard]] bool is_better(const Value& left, const Value& right, Direction direction) {
    return direction == Direction::maximum ? left > right : left < right;
}

/// Returns whether a divisor is known to be positive.
[[nodiscard]] inline bool positive(const Interval& value) {
    return value.negated_low < 0;
}
template <class Value>
[[nodiscard]] bool positive(const Value& value) {
    return value > 0;
}

[[nodiscard]] inline bool is_zero(const Interval& value) {
    return value.high == 0 && value.negated_low == 0;
}
template <class Value>
[[nodiscard]] bool is_zero(const Value& value) {
    return value == 0;
}

template <class Value>
[[nodiscard]] Value whole_number(int value) {
    return Value(value);
}
template <>
[[nodiscard]] inline Interval whole_number<Interval>(int value) {
    return {static_cast<double>(value), static_cast<double>(value)};
}

inline void poll(diagnostics::Budget* budget) {
    if (budget != nullptr) budget->poll();
}

}  // namespace robochart::markov
