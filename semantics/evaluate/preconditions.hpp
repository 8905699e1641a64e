// SPDX-License-Identifier: Apache-2.0
// Preconditions of the functions that expressions call (semantics 3.5). Computes whether they are true, and whether
// this can be decided without running the model.
#pragma once

#include <vector>

#include "semantics/evaluate/evaluate.hpp"

namespace robochart::ir {

/// True if the expression binds variables: preconditions inside are checked for each of their values.
[[nodiscard]] bool binds_names(ExprKind);

/// True if the expression reads a variable, the value of a trigger or a clock, so that it cannot be evaluated in
/// advance.
[[nodiscard]] bool depends_on_state(const Expr&);

/// True if the function may be called with these arguments. The preconditions of functions that its precondition calls
/// are checked first. Throws like evaluate_expression().
[[nodiscard]] bool precondition_holds(const System&, const Instantiation&, const Function&,
                                      const std::vector<Value>& arguments);

/// True if the precondition of this call can be false. The function may belong to the model or to a toolkit. It may
/// also be used as a value, which has a pair for every argument that satisfies the precondition. False if the
/// expression is not a call, or if constants (by ConstantId) and literals alone make the precondition true.
[[nodiscard]] bool precondition_can_fail(const System&, const Instantiation&, const std::vector<Value>& constants,
                                         const Expr& call);
/// True if some call in the expression has a precondition that can be false. A function used as a value is not a call.
[[nodiscard]] bool preconditions_can_fail(const System&, const Instantiation&, const std::vector<Value>& constants,
                                          const Expr&);

}  // namespace robochart::ir
