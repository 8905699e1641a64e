// SPDX-License-Identifier: Apache-2.0
// Numbers as pairs of doubles that enclose them. Arithmetic rounds outward, and only if the result is not a double.
#pragma once

#include <limits>

namespace robochart::markov {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// low <= exact value <= high; both are infinite if the value is.
struct Enclosure {
    double low = 0;
    double high = 0;

    [[nodiscard]] bool is_exact() const { return low == high; }
    [[nodiscard]] double middle() const;
    /// (high - low) / the greater absolute bound, rounded up; 0 if exact.
    [[nodiscard]] double relative_width() const;
    friend bool operator==(const Enclosure&, const Enclosure&) = default;
};

/// These operations are for expressions over results, in the default rounding mode (to nearest).
[[nodiscard]] Enclosure operator+(Enclosure left, Enclosure right);
[[nodiscard]] Enclosure operator-(Enclosure left, Enclosure right);
[[nodiscard]] Enclosure operator*(Enclosure left, Enclosure right);
/// Returns the interval from -infinity to infinity if the divisor may be 0.
[[nodiscard]] Enclosure operator/(Enclosure left, Enclosure right);
/// 1 - p for a probability; the result stays within 0 .. 1.
[[nodiscard]] Enclosure complement(Enclosure probability);

}  // namespace robochart::markov
