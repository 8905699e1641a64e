// Checked 64-bit arithmetic: nothing means that the exact result does not fit.
#pragma once

#include <cstdint>
#include <optional>

namespace robochart::ir {

[[nodiscard]] std::optional<std::int64_t> checked_add(std::int64_t, std::int64_t);
[[nodiscard]] std::optional<std::int64_t> checked_subtract(std::int64_t, std::int64_t);
[[nodiscard]] std::optional<std::int64_t> checked_multiply(std::int64_t, std::int64_t);
/// 10^exponent.
[[nodiscard]] std::optional<std::int64_t> power_of_ten(std::uint32_t exponent);
/// CSPM's `/`: the quotient rounded down (towards minus infinity). The FDR2 manual (appendix A.1.2) asks m = n*(m/n) +
/// m%n, |m%n| < |n| and m%n >= 0 for n > 0, which is rounding down; for n < 0, where it leaves the choice, rounding
/// down too. Nothing if the divisor is 0 or the quotient does not fit.
[[nodiscard]] std::optional<std::int64_t> floor_divide(std::int64_t, std::int64_t);
/// CSPM's `%`: what floor_divide leaves over; it has the divisor's sign. Nothing if the divisor is 0.
[[nodiscard]] std::optional<std::int64_t> floor_modulus(std::int64_t, std::int64_t);
/// left * right / divisor rounded down, the product not rounded or cut. Nothing if the divisor is 0.
[[nodiscard]] std::optional<std::int64_t> multiply_divide(std::int64_t left, std::int64_t right, std::int64_t divisor);

}  // namespace robochart::ir
