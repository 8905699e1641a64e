// SPDX-License-Identifier: Apache-2.0
// Functions whose contract names their result, so that no search for a value is necessary.
#pragma once

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// E if the only postcondition is `result == E`, with the operands in any order, where E has the type of the result and
/// does not read `result`. Otherwise null. If E has a value, it is the only value that satisfies the postcondition.
[[nodiscard]] ExprPtr result_expression(const Function&);

/// Returns whether the conditions of the function call it again, also through other functions.
[[nodiscard]] bool is_recursive(const System&, const Function&);

}  // namespace robochart::ir
