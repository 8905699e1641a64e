// SPDX-License-Identifier: Apache-2.0
// Computes checked arithmetic on 64-bit integers. Products are computed in 128 bits.
#include "semantics/ir/arithmetic.hpp"

#include <limits>

namespace robochart::ir {
namespace {

__extension__ using Wide = __int128;

std::optional<std::int64_t> narrow_to_64_bits(Wide value) {
    if (value < std::numeric_limits<std::int64_t>::min() || value > std::numeric_limits<std::int64_t>::max())
        return std::nullopt;
    return static_cast<std::int64_t>(value);
}

Wide floor_divide_wide(Wide dividend, Wide divisor) {
    const Wide quotient = dividend / divisor;
    const bool inexact = dividend % divisor != 0;
    return inexact && ((dividend < 0) != (divisor < 0)) ? quotient - 1 : quotient;
}

}  // namespace

std::optional<std::int64_t> checked_add(std::int64_t left, std::int64_t right) {
    return narrow_to_64_bits(Wide{left} + right);
}

std::int64_t number_after(std::int64_t value) {
    return checked_add(value, 1).value_or(value);
}

std::optional<std::int64_t> checked_subtract(std::int64_t left, std::int64_t right) {
    return narrow_to_64_bits(Wide{left} - right);
}

std::optional<std::int64_t> checked_multiply(std::int64_t left, std::int64_t right) {
    return narrow_to_64_bits(Wide{left} * right);
}

std::optional<std::int64_t> power_of_ten(std::uint32_t exponent) {
    std::optional<std::int64_t> result = 1;
    for (std::uint32_t i = 0; i < exponent && result; ++i) result = checked_multiply(*result, 10);
    return result;
}

std::optional<std::int64_t> floor_divide(std::int64_t dividend, std::int64_t divisor) {
    if (divisor == 0) return std::nullopt;
    return narrow_to_64_bits(floor_divide_wide(dividend, divisor));
}

std::optional<std::int64_t> floor_modulus(std::int64_t dividend, std::int64_t divisor) {
    if (divisor == 0) return std::nullopt;
    const Wide quotient = floor_divide_wide(dividend, divisor);
    return narrow_to_64_bits(Wide{dividend} - quotient * divisor);
}

std::optional<std::int64_t> multiply_divide(std::int64_t left, std::int64_t right, std::int64_t divisor) {
    if (divisor == 0) return std::nullopt;
    return narrow_to_64_bits(floor_divide_wide(Wide{left} * right, divisor));
}

}  // namespace robochart::ir
