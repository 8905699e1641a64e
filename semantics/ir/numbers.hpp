// SPDX-License-Identifier: Apache-2.0
// Reads and writes number literals exactly.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Reads digits with an optional sign. Returns no value if the text has another form or the number does not fit into 64
/// bits.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view);
/// Reads a decimal such as `3` or `-0.75`. Trailing zeros of the fraction are removed (0.50 is 5 * 10^-1). Returns no
/// value if the number needs more than 64 bits or more than 18 decimal places.
[[nodiscard]] std::optional<Decimal> parse_decimal(std::string_view);
/// Returns the shortest RoboChart literal of the number: "-0.75", "3".
[[nodiscard]] std::string to_string(const Decimal&);
/// Returns a number in units of 1/scale as a decimal: -1088 at scale 100 is "-10.88". The scale is a power of ten.
[[nodiscard]] std::string decimal_text(std::int64_t number, std::int64_t scale);

}  // namespace robochart::ir
