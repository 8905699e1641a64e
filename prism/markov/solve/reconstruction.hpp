// SPDX-License-Identifier: Apache-2.0
// Reconstructs fractions from their values modulo a large number.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "prism/markov/model/model.hpp"

namespace robochart::markov {

using Integer = boost::multiprecision::cpp_int;

/// Returns digits[0] + digits[1] base + digits[2] base^2 + ...
[[nodiscard]] Integer from_digits(std::span<const std::uint32_t> digits, std::uint32_t base);

/// A fraction in lowest terms with numerator = value * denominator modulo `modulus`; `value` is from 0 to modulus - 1.
/// It is computed by the Euclidean algorithm (Wang, 1981). There is no value if no such fraction exists. |numerator|
/// and denominator must be much smaller than the root of `modulus`, so that a number without such a fraction seldom
/// gets one by chance.
struct Fraction {
    Integer numerator;
    Integer denominator;
};
[[nodiscard]] std::optional<Fraction> reconstruct_fraction(const Integer& value, const Integer& modulus);

/// The fractions of several values with a common denominator. If a value has no fraction, contains the value's index
/// instead.
struct CommonFractions {
    std::vector<Integer> numerators;
    Integer denominator = 1;
    std::optional<std::size_t> without;
};

/// Returns the fractions of `count` values, which the function `value` returns. Starts at index `first`, which should
/// be the value without a fraction in the previous call.
[[nodiscard]] CommonFractions common_fractions(std::size_t count, std::size_t first, const Integer& modulus,
                                               const std::function<Integer(std::size_t)>& value);

}  // namespace robochart::markov
