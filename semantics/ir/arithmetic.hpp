// SPDX-License-Identifier: Apache-2.0
// Provides checked 64-bit arithmetic. A function returns no value if the exact result does not fit into 64 bits.
#pragma once

#include <cstdint>
#include <optional>

namespace robochart::ir {

[[nodiscard]] std::optional<std::int64_t> checked_add(std::int64_t, std::int64_t);
/// Returns value + 1, or the largest number if value + 1 does not fit.
[[nodiscard]] std::int64_t number_after(std::int64_t value);
[[nodiscard]] std::optional<std::int64_t> checked_subtract(std::int64_t, std::int64_t);
[[nodiscard]] std::optional<std::int64_t> checked_multiply(std::int64_t, std::int64_t);
/// Returns 10^exponent.
[[nodiscard]] std::optional<std::int64_t> power_of_ten(std::uint32_t exponent);
/// Computes CSPM's `/`: the quotient rounded down (towards minus infinity). The FDR2 manual (appendix A.1.2) requires m
/// = n*(m/n) + m%n, |m%n| < |n|, and m%n >= 0 for n > 0, which means rounding down. For n < 0, the manual does not
/// define the result. This function also rounds down for n < 0. It returns no value if the divisor is 0 or the quotient
/// does not fit.
[[nodiscard]] std::optional<std::int64_t> floor_divide(std::int64_t, std::int64_t);
/// Computes CSPM's `%`: the remainder of floor_divide. The remainder has the sign of the divisor. Returns no value if
/// the divisor is 0.
[[nodiscard]] std::optional<std::int64_t> floor_modulus(std::int64_t, std::int64_t);
/// Returns left * right / divisor, rounded down. The product is exact. Returns no value if the divisor is 0 or the
/// result does not fit.
[[nodiscard]] std::optional<std::int64_t> multiply_divide(std::int64_t left, std::int64_t right, std::int64_t divisor);

}  // namespace robochart::ir
