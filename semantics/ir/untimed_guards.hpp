// Conditions without time: what the untimed semantics makes of a condition that reads clocks.
#pragma once

#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// A condition as the untimed semantics has it.
struct UntimedGuard {
    ExprPtr kept;  ///< true wherever the condition is true for some values of the clocks; null: always
    std::vector<ExprPtr> left_open;  ///< the parts that read clocks, as they stand in the condition
};

/// Parts of `/\`, `\/`, `not`, `=>` and `if` that read no clock stay; any other part that reads one may be true and may
/// be false. So every transition that can fire at some time can fire without time.
[[nodiscard]] UntimedGuard untimed_guard(const ExprPtr& condition);

}  // namespace robochart::ir
