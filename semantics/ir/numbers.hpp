// Number literals: reading and writing them exactly.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Digits with an optional sign; nothing if it is not that or does not fit into 64 bits.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view);
/// `3`, `-0.75`: without trailing zeros in the fraction (0.50 is 5 * 10^-1). Nothing beyond 64 bits or 18 places.
[[nodiscard]] std::optional<Decimal> parse_decimal(std::string_view);
/// The shortest RoboChart literal: "-0.75", "3".
[[nodiscard]] std::string to_string(const Decimal&);

}  // namespace robochart::ir
