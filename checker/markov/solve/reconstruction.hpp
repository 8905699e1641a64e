// Fractions from what they are modulo a large number.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "checker/markov/model/model.hpp"

namespace robochart::markov {

using Integer = boost::multiprecision::cpp_int;

/// digits[0] + digits[1] base + digits[2] base^2 + ...
[[nodiscard]] Integer from_digits(std::span<const std::uint32_t> digits, std::uint32_t base);

/// A fraction in lowest terms with numerator = value * denominator modulo `modulus`, such that |numerator| and
/// denominator are so much smaller than its root that a number without such a fraction seldom seems to have one;
/// nothing where none is. `value` is from 0 to modulus - 1. By the Euclidean algorithm (Wang, 1981).
struct Fraction {
    Integer numerator;
    Integer denominator;
};
[[nodiscard]] std::optional<Fraction> reconstructed(const Integer& value, const Integer& modulus);

/// The fractions of several values, all with one denominator; where one has none, its place.
struct CommonFractions {
    std::vector<Integer> numerators;
    Integer denominator = 1;
    std::optional<std::size_t> without;
};

/// Of `count` values, which `value` gives. Begins at `first`: where one has none, it is best that one.
[[nodiscard]] CommonFractions common_fractions(std::size_t count, std::size_t first, const Integer& modulus,
                                               const std::function<Integer(std::size_t)>& value);

}  // namespace robochart::markov
