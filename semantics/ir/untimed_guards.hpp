// SPDX-License-Identifier: Apache-2.0
// Converts conditions that read clocks to conditions of the untimed semantics.
#pragma once

#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// A condition in the untimed semantics.
struct UntimedGuard {
    ExprPtr kept;  ///< true whenever some values of the clocks make the condition true; null: always true
    std::vector<ExprPtr> left_open;  ///< the parts that read clocks and are not in `kept`
};

/// Converts a condition. The result contains the operands of `/\`, `\/`, `not`, `=>` and `if` that read no clock. A
/// part that reads a clock may be true or false. So every transition that can fire at some time can also fire in the
/// untimed semantics.
[[nodiscard]] UntimedGuard untimed_guard(const ExprPtr& condition);

}  // namespace robochart::ir
