// SPDX-License-Identifier: Apache-2.0
// Reads and writes number literals exactly.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Digits with an optional sign; no value if the text has another form or does not fit into 64 bits.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view);
/// `3`, `-0.75`: trailing zeros of the fraction are removed (0.50 is 5 * 10^-1). No value beyond 64 bits or 18 decimal
/// places.
[[nodiscard]] std::optional<Decimal> parse_decimal(std::string_view);
/// The shortest RoboChart literal: "-0.75", "3".
[[nodiscard]] std::string to_string(const Decimal&);
/// `number` in units of 1/scale as a decimal: -1088 at scale 100 is "-10.88". The scale is a power of ten.
[[nodiscard]] std::string decimal_text(std::int64_t number, std::int64_t scale);

}  // namespace robochart::ir
