// SPDX-License-Identifier: Apache-2.0
// Finds the places at which a program may have to wait. The code must be able to stop at these places and resume later.
#pragma once

#include <vector>

#include "cpp_emit/expressions/generation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Whether the statement may stop before it is finished. Such statements are waits, inputs, outputs, calls of defined
/// operations, calls of functions outside their preconditions, and writes that may be held up.
[[nodiscard]] bool may_suspend(const Generation&, const Unit&, const ir::StmtPtr&);

/// Whether some action of the machine may last beyond a cycle: it suspends for a reason other than a wait of 0 or a
/// call of an operation that ends at once.
[[nodiscard]] bool actions_take_time(const Generation&, const Unit&);

/// Whether a transition of the machine has a deadline that counts only while its guard holds (semantics 3.10).
[[nodiscard]] bool guards_deadlines(const ir::Machine&);

/// The expressions that the statement evaluates before any effect, in the order in which the semantics checks
/// preconditions. The list is empty for an input statement, because its preconditions are checked with the received
/// value.
[[nodiscard]] std::vector<const ir::Expr*> evaluated_first(const ir::Stmt&);

/// Whether a thread of the unit that is before a call of the platform may hold up writes of others. While the thread is
/// there, writes are not propagated to its machine, and a variable accepts a write only when the previous one has
/// reached all machines that require the variable (semantics 3.7). True if others write, at least twice, a variable
/// that the unit's machine requires.
[[nodiscard]] bool calls_hold_up_writes(const Generation&, const Unit&);

/// Whether an argument of the call depends on a variable. Others may write the variable before it is read.
[[nodiscard]] bool reads_variables(const ir::Stmt& call);

}  // namespace robochart::cpp_emit
