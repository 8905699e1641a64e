// SPDX-License-Identifier: Apache-2.0
// Replaces calls of functions by their bodies. Private to this component.
#pragma once

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Returns the expression, with calls of functions replaced by their results. A function is replaced if it has no
/// precondition and one postcondition `result == E`. E must have the type of the result (real, int or boolean), and
/// must consist of arithmetic, comparisons, logic, choices and calls of functions that are replaced. In the ideal
/// semantics, E is then the only value that satisfies the postcondition. Other calls are not changed. Equal expressions
/// have equal pointers.
[[nodiscard]] ExprPtr inline_calls(const System& system, const ExprPtr& expr);

}  // namespace robochart::ir
