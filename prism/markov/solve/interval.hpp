// SPDX-License-Identifier: Apache-2.0
// Implements intervals whose operations round outward. The processor must round upward.
//
// Why every bound is valid, with and without optimisation:
// - RoundUpward sets the mode with fesetround, which every operation of SSE2 and NEON obeys, and checks that it has
//   effect.
// - An interval stores the *negated* low bound. So both bounds only ever need rounding upward, and no operation depends
//   on a change of mode in between.
// - The optimiser must not fold constants to nearest, nor move a minus sign through a rounded operation: the folder is
//   compiled with -frounding-math. Operands come from the heap, so no operation moves over the call of fesetround.
// - Minus signs are exact. Contraction of a*b+c to one rounding only makes the result sharper.
// Tests compare all operators with rational arithmetic.
#pragma once

#include <algorithm>
#include <limits>

#include "prism/markov/solve/enclosure.hpp"

namespace robochart::markov {

/// Sets this thread's rounding mode to upward during its lifetime. Throws std::runtime_error if the system does not
/// support it.
class RoundUpward {
public:
    RoundUpward();
    ~RoundUpward();
    RoundUpward(const RoundUpward&) = delete;
    RoundUpward& operator=(const RoundUpward&) = delete;

private:
    int before_;
};

/// Valid during the lifetime of a RoundUpward.
struct Interval {
    double negated_low = 0;
    double high = 0;

    Interval() = default;
    Interval(double low_bound, double high_bound) : negated_low(-low_bound), high(high_bound) {}

    [[nodiscard]] double low() const { return -negated_low; }
    /// Returns a double between the bounds.
    [[nodiscard]] double middle() const { return std::clamp(high / 2 - negated_low / 2, low(), high); }
    [[nodiscard]] Enclosure enclosure() const { return {0.0 - negated_low, high}; }

    Interval& operator+=(const Interval& other) {
        negated_low += other.negated_low;
        high += other.high;
        return *this;
    }
    friend Interval operator+(Interval left, const Interval& right) { return left += right; }
    /// The left factor must not be negative.
    friend Interval operator*(const Interval& factor, const Interval& value) {
        Interval result;
        result.negated_low = (value.negated_low > 0 ? factor.high : factor.low()) * value.negated_low;
        result.high = (value.high < 0 ? factor.low() : factor.high) * value.high;
        return result;
    }
    /// The divisor must be positive.
    friend Interval operator/(const Interval& value, const Interval& divisor) {
        Interval result;
        result.negated_low = value.negated_low / (value.negated_low > 0 ? divisor.low() : divisor.high);
        result.high = value.high / (value.high < 0 ? divisor.high : divisor.low());
        return result;
    }
    friend Interval operator-(const Interval& left, const Interval& right) {
        Interval result;
        result.negated_low = left.negated_low + right.high;
        result.high = left.high + right.negated_low;
        return result;
    }
    friend bool operator==(const Interval&, const Interval&) = default;
};

}  // namespace robochart::markov
