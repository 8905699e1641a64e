// SPDX-License-Identifier: Apache-2.0
// Answers comparisons of numbers.
#pragma once

#include <compare>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Returns the result of the comparison `kind` (`equal`, `less`, ...) for two operands with this order. If the operands
/// are unordered (NaN), only `not_equal` is true, as in C++.
[[nodiscard]] constexpr bool comparison_answer(ExprKind kind, std::partial_ordering order) {
    if (kind == ExprKind::less) return order < 0;
    if (kind == ExprKind::less_equal) return order <= 0;
    if (kind == ExprKind::greater) return order > 0;
    if (kind == ExprKind::greater_equal) return order >= 0;
    return (order == 0) == (kind == ExprKind::equal);
}

}  // namespace robochart::ir
