// SPDX-License-Identifier: Apache-2.0
// Finds the places where a program may have to wait. There, the code must be able to stop and resume later.
#pragma once

#include <vector>

#include "cpp_emit/expressions/generation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Returns true if the statement may stop before it is finished. This is possible for waits, inputs, outputs, writes
/// that may be held up, calls of defined operations, and calls of functions outside their preconditions.
[[nodiscard]] bool may_suspend(const Generation&, const Unit&, const ir::StmtPtr&);

/// Returns true if an action of the machine may continue after the end of a cycle. A wait of 0 does not, and neither
/// does a call of an operation that ends at once.
[[nodiscard]] bool actions_take_time(const Generation&, const Unit&);

/// Returns whether a transition of the machine has a deadline that runs only while the transition's guard holds
/// (semantics 3.10).
[[nodiscard]] bool guards_deadlines(const ir::Machine&);

/// Returns the expressions that the statement evaluates before any effect, in the order in which the semantics
/// checks their preconditions. Returns an empty list for inputs: their preconditions are checked with the received
/// value.
[[nodiscard]] std::vector<const ir::Expr*> evaluated_first(const ir::Stmt&);

/// Returns true if a thread of the unit may hold up writes of other machines while it is before a call of the platform.
/// During this time, writes do not reach its machine. A variable accepts a write only when the previous one has reached
/// all machines that require the variable (semantics 3.7). So the result is true if other machines write at least twice
/// to a variable that the unit's machine requires.
[[nodiscard]] bool calls_hold_up_writes(const Generation&, const Unit&);

/// Returns whether an argument of the call depends on a variable. Other machines may write the variable before it is
/// read.
[[nodiscard]] bool reads_variables(const ir::Stmt& call);

}  // namespace robochart::cpp_emit
