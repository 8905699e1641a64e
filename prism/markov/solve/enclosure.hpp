// SPDX-License-Identifier: Apache-2.0
// Represents numbers as pairs of doubles that enclose them. Results that are no doubles are rounded outward.
#pragma once

#include <limits>

namespace robochart::markov {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// The exact value is between `low` and `high`. Both are infinite if the value is infinite.
struct Enclosure {
    double low = 0;
    double high = 0;

    [[nodiscard]] bool is_exact() const { return low == high; }
    [[nodiscard]] double middle() const;
    /// Returns (high - low) / the greater absolute bound, rounded up; 0 for an exact value.
    [[nodiscard]] double relative_width() const;
    friend bool operator==(const Enclosure&, const Enclosure&) = default;
};

/// The operations combine results. They are for the default rounding mode (to nearest).
[[nodiscard]] Enclosure operator+(Enclosure left, Enclosure right);
[[nodiscard]] Enclosure operator-(Enclosure left, Enclosure right);
[[nodiscard]] Enclosure operator*(Enclosure left, Enclosure right);
/// Returns the interval from -infinity to infinity if the divisor may be 0.
[[nodiscard]] Enclosure operator/(Enclosure left, Enclosure right);
/// Returns 1 - p for a probability p. The result stays within 0 .. 1.
[[nodiscard]] Enclosure complement(Enclosure probability);

}  // namespace robochart::markov
