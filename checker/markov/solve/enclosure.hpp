// Numbers as two doubles that enclose them. Arithmetic rounds outward, and only where the result is no double.
#pragma once

#include <limits>

namespace robochart::markov {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// low <= exact value <= high; both infinite where the value is.
struct Enclosure {
    double low = 0;
    double high = 0;

    [[nodiscard]] bool exact() const { return low == high; }
    [[nodiscard]] double middle() const;
    /// (high - low) / the greater absolute bound, rounded up; 0 where exact.
    [[nodiscard]] double relative_width() const;
    friend bool operator==(const Enclosure&, const Enclosure&) = default;
};

/// For expressions over results, in the usual rounding mode (to nearest).
[[nodiscard]] Enclosure operator+(Enclosure left, Enclosure right);
[[nodiscard]] Enclosure operator-(Enclosure left, Enclosure right);
[[nodiscard]] Enclosure operator*(Enclosure left, Enclosure right);
/// From -infinity to infinity where the divisor may be 0.
[[nodiscard]] Enclosure operator/(Enclosure left, Enclosure right);
/// 1 - p, of a probability: stays within 0 .. 1.
[[nodiscard]] Enclosure complement(Enclosure probability);

}  // namespace robochart::markov
