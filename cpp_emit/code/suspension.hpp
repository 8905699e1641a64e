// SPDX-License-Identifier: Apache-2.0
// Finds the places at which a program may have to wait. The code must be able to stop at these places and resume later.
#pragma once

#include <vector>

#include "cpp_emit/expressions/generation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Returns whether the statement may stop before it is finished. This is possible for waits, inputs, outputs, calls of
/// defined operations, calls of functions outside their preconditions, and writes that may be held up.
[[nodiscard]] bool may_suspend(const Generation&, const Unit&, const ir::StmtPtr&);

/// Returns whether some action of the machine may last beyond a cycle. A wait of 0, or a call of an operation that ends
/// at once, does not last beyond a cycle.
[[nodiscard]] bool actions_take_time(const Generation&, const Unit&);

/// Returns whether a transition of the machine has a deadline that runs only while the transition's guard holds
/// (semantics 3.10).
[[nodiscard]] bool guards_deadlines(const ir::Machine&);

/// Returns the expressions that the statement evaluates before any effect, in the order in which the semantics checks
/// preconditions. The list is empty for an input statement, because its preconditions are checked with the received
/// value.
[[nodiscard]] std::vector<const ir::Expr*> evaluated_first(const ir::Stmt&);

/// Returns whether a thread of the unit that is before a call of the platform may hold up writes of other machines.
/// While the thread is there, writes are not propagated to its machine. A variable accepts a write only when the
/// previous one has reached all machines that require the variable (semantics 3.7). So the result is true if other
/// machines write, at least twice, a variable that the unit's machine requires.
[[nodiscard]] bool calls_hold_up_writes(const Generation&, const Unit&);

/// Returns whether an argument of the call depends on a variable. Other machines may write the variable before it is
/// read.
[[nodiscard]] bool reads_variables(const ir::Stmt& call);

}  // namespace robochart::cpp_emit
