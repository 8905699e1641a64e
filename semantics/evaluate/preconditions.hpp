// Preconditions of the functions that expressions call (semantics 3.5): whether they hold, and whether that can be
// decided without running the model.
#pragma once

#include <vector>

#include "semantics/evaluate/evaluate.hpp"

namespace robochart::ir {

/// Whether the expression has variables of its own: preconditions inside are asked for each of their values.
[[nodiscard]] bool binds(ExprKind);

/// Whether the function may be called with these arguments; the functions that its preconditions call are asked first.
/// Throws as evaluate() does.
[[nodiscard]] bool precondition_holds(const System&, const Instantiation&, const Function&,
                                      const std::vector<Value>& arguments);

/// Whether the precondition of this call can be false: of a function of the model or of a toolkit, or of a function as
/// a value, which has a pair wherever it holds. False for what is no call, and where constants (by ConstantId) and
/// literals alone make it true.
[[nodiscard]] bool precondition_can_fail(const System&, const Instantiation&, const std::vector<Value>& constants,
                                         const Expr& call);
/// Whether some call in the expression has a precondition that can be false. A function as a value is not called.
[[nodiscard]] bool preconditions_can_fail(const System&, const Instantiation&, const std::vector<Value>& constants,
                                          const Expr&);

}  // namespace robochart::ir
