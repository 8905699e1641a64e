// SPDX-License-Identifier: Apache-2.0
// Evaluates the preconditions of functions that expressions call (semantics 3.5). Decides whether a precondition can be
// false.
#pragma once

#include <vector>

#include "semantics/evaluate/evaluate.hpp"

namespace robochart::ir {

/// True if the expression binds variables. Preconditions inside such an expression are checked for each value of the
/// variables.
[[nodiscard]] bool binds_names(ExprKind);

/// Returns true if the expression reads a variable, the value of a trigger or a clock. It can then only be evaluated in
/// a state.
[[nodiscard]] bool depends_on_state(const Expr&);

/// Returns true if the function may be called with these arguments. If its precondition calls functions, their
/// preconditions are checked first. Throws like evaluate_expression().
[[nodiscard]] bool precondition_holds(const System&, const Instantiation&, const Function&,
                                      const std::vector<Value>& arguments);

/// True if the expression is a call whose precondition can be false. The function may belong to the model or to a
/// toolkit. It may also be used as a value, which has a pair for every argument that satisfies the precondition. The
/// precondition cannot be false if constants (by ConstantId) and literals alone make it true.
[[nodiscard]] bool precondition_can_fail(const System&, const Instantiation&, const std::vector<Value>& constants,
                                         const Expr& call);
/// True if some call in the expression has a precondition that can be false. A function used as a value is not a call.
[[nodiscard]] bool preconditions_can_fail(const System&, const Instantiation&, const std::vector<Value>& constants,
                                          const Expr&);

}  // namespace robochart::ir
