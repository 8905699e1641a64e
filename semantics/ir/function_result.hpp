// SPDX-License-Identifier: Apache-2.0
// Recognises functions whose contract states their result. For such a function, no search for a result is necessary.
#pragma once

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Returns E if the only postcondition is `result == E` or `E == result`. E must have the type of the result and must
/// not read `result`. Returns null for all other functions. If E has a value, this value is the only one that satisfies
/// the postcondition.
[[nodiscard]] ExprPtr result_expression(const Function&);

/// Returns whether the conditions of the function call the function again, directly or through other functions.
[[nodiscard]] bool is_recursive(const System&, const Function&);

}  // namespace robochart::ir
