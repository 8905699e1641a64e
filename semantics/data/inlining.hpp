// SPDX-License-Identifier: Apache-2.0
// Replaces calls of functions by their bodies. Private to this component.
#pragma once

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Returns the expression with results in place of calls of functions. It replaces a call if the function has no
/// precondition and one postcondition `result == E`. E must have the type of the result (real, int or boolean), and
/// must consist of arithmetic, comparisons, logic, choices, and calls that can be replaced. In the ideal semantics, the
/// value of E is then the only one that satisfies the postcondition. Other calls do not change. Equal expressions have
/// equal pointers.
[[nodiscard]] ExprPtr inline_calls(const System& system, const ExprPtr& expr);

}  // namespace robochart::ir
