// SPDX-License-Identifier: Apache-2.0
// Converts conditions that read clocks to conditions of the untimed semantics.
#pragma once

#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// A condition in the untimed semantics.
struct UntimedGuard {
    ExprPtr kept;  ///< true whenever the condition is true for some values of the clocks; null: always true
    std::vector<ExprPtr> left_open;  ///< the parts that read clocks, as written
};

/// Operands of `/\`, `\/`, `not`, `=>` and `if` that read no clock are kept. Any other part that reads a clock is taken
/// as possibly true and possibly false. So every transition that can fire at some time can fire without time.
[[nodiscard]] UntimedGuard untimed_guard(const ExprPtr& condition);

}  // namespace robochart::ir
