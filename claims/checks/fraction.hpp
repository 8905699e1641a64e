// SPDX-License-Identifier: Apache-2.0
// Computes with exact fractions, which are the values of conditions.
#pragma once

#include <compare>
#include <cstdint>
#include <stdexcept>
#include <string_view>

namespace robochart::claims {

/// Thrown if a condition cannot be computed exactly; the text contains the reason.
struct NotComputable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A fraction in lowest terms. Arithmetic throws NotComputable if the numerator or denominator does not fit into 64
/// bits.
class Fraction {
public:
    constexpr Fraction() = default;
    explicit constexpr Fraction(std::int64_t number) : above_(number) {}
    /// `below` is positive.
    Fraction(std::int64_t above, std::int64_t below) { *this = reduced(above, below); }
    /// Returns the value of digits with at most one point, such as "0.25".
    [[nodiscard]] static Fraction of_decimal(std::string_view text);

    [[nodiscard]] std::int64_t numerator() const { return above_; }
    [[nodiscard]] std::int64_t denominator() const { return below_; }
    [[nodiscard]] bool is_whole() const { return below_ == 1; }

    friend Fraction operator+(const Fraction& a, const Fraction& b) {
        return reduced(Wide(a.above_) * b.below_ + Wide(b.above_) * a.below_, Wide(a.below_) * b.below_);
    }
    friend Fraction operator-(const Fraction& a, const Fraction& b) { return a + Fraction(-1) * b; }
    friend Fraction operator*(const Fraction& a, const Fraction& b) {
        return reduced(Wide(a.above_) * b.above_, Wide(a.below_) * b.below_);
    }
    friend bool operator==(const Fraction&, const Fraction&) = default;
    friend std::strong_ordering operator<=>(const Fraction& a, const Fraction& b) {
        return Wide(a.above_) * b.below_ <=> Wide(b.above_) * a.below_;
    }

private:
    __extension__ using Wide = __int128;
    static Fraction reduced(Wide above, Wide below);

    std::int64_t above_ = 0, below_ = 1;
};

}  // namespace robochart::claims
