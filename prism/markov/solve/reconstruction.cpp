// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/solve/reconstruction.hpp"

#include <utility>

namespace robochart::markov {
namespace {

/// The spare bits: a number without a suitable fraction seems to have one with probability 2^-spare.
constexpr unsigned spare = 32;

class DigitSum {
public:
    DigitSum(std::span<const std::uint32_t> digits, std::uint32_t base) : digits_(digits) {
        powers_.emplace_back(base);  // base^(2^k)
        for (std::size_t length = 2; length < digits.size(); length *= 2)
            powers_.emplace_back(powers_.back() * powers_.back());
    }

    [[nodiscard]] Integer value_of_all_digits() const { return value_of_digits(0, digits_.size(), powers_.size()); }

private:
    /// Returns the number with the digits from `begin` to `end`, at most 2^level digits.
    [[nodiscard]] Integer value_of_digits(std::size_t begin, std::size_t end, std::size_t level) const {
        if (begin >= end) return 0;
        if (end - begin == 1) return digits_[begin];
        const std::size_t half = begin + (std::size_t{1} << (level - 1));
        if (half >= end) return value_of_digits(begin, end, level - 1);
        return value_of_digits(begin, half, level - 1) + value_of_digits(half, end, level - 1) * powers_[level - 1];
    }

    std::span<const std::uint32_t> digits_;
    std::vector<Integer> powers_;
};

unsigned bits(const Integer& value) {
    return value == 0 ? 0 : static_cast<unsigned>(msb(value)) + 1;
}

}  // namespace

Integer from_digits(std::span<const std::uint32_t> digits, std::uint32_t base) {
    return DigitSum(digits, base).value_of_all_digits();
}

std::optional<Fraction> reconstruct_fraction(const Integer& value, const Integer& modulus) {
    // Invariant: remainder = factor * value modulo `modulus`. Remainders decrease and factors grow.
    const unsigned most = (bits(modulus) - 1) / 2;
    Integer before = modulus;
    Integer remainder = value;
    Integer factor_before = 0;
    Integer factor = 1;
    while (bits(remainder) > most) {
        Integer quotient;
        Integer next;
        divide_qr(before, remainder, quotient, next);
        before = std::exchange(remainder, std::move(next));
        Integer next_factor = factor_before - quotient * factor;
        factor_before = std::exchange(factor, std::move(next_factor));
    }
    if (factor < 0) {
        factor = -factor;
        remainder = -remainder;
    }
    if (bits(abs(remainder)) + bits(factor) + spare > bits(modulus)) return std::nullopt;
    const Integer common = gcd(remainder, factor);
    if (common > 1) return std::nullopt;
    return Fraction{std::move(remainder), std::move(factor)};
}

CommonFractions common_fractions(std::size_t count, std::size_t first, const Integer& modulus,
                                 const std::function<Integer(std::size_t)>& value) {
    CommonFractions result;
    std::vector<Integer> denominators(count);  // each divides the next one
    result.numerators.resize(count);
    for (std::size_t step = 0; step < count; ++step) {
        const std::size_t at = (first + step) % count;
        // Usually the current denominator is also a denominator of this value.
        auto fraction = reconstruct_fraction(Integer(value(at) * result.denominator % modulus), modulus);
        if (!fraction) {
            result.without = at;
            return result;
        }
        result.denominator *= fraction->denominator;
        denominators[at] = result.denominator;
        result.numerators[at] = std::move(fraction->numerator);
    }
    for (std::size_t at = 0; at < count; ++at)
        if (denominators[at] != result.denominator) result.numerators[at] *= result.denominator / denominators[at];
    return result;
}

}  // namespace robochart::markov
