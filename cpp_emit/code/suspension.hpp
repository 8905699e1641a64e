// SPDX-License-Identifier: Apache-2.0
// Decides where a program may have to wait, so that its code must be able to stop there and resume later.
#pragma once

#include <vector>

#include "cpp_emit/expressions/generation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Whether the statement can stop before it is finished: waits, inputs, outputs, calls of defined operations, functions
/// outside their preconditions, and writes that may be held up.
[[nodiscard]] bool suspends(const Generation&, const Unit&, const ir::StmtPtr&);

/// Whether some action of the machine may last beyond a cycle: it suspends, other than for a wait of 0 or a call of an
/// operation that ends at once.
[[nodiscard]] bool actions_take_time(const Generation&, const Unit&);

/// Whether a transition of the machine has a deadline that counts only while its guard holds (semantics 3.10).
[[nodiscard]] bool guards_deadlines(const ir::Machine&);

/// The expressions that the statement evaluates before any effect, in the order in which the semantics checks
/// preconditions. An input statement has none, because it checks them with its value, which has not arrived yet.
[[nodiscard]] std::vector<const ir::Expr*> evaluated_first(const ir::Stmt&);

/// Whether a thread of the unit that is before a call of the platform may hold up writes of others. Writes are not
/// propagated to a machine while one of its threads is there, and a variable accepts no other write before the last one
/// is propagated to all machines that require it (semantics 3.7). True if others write at least twice a variable that
/// the unit's machine requires.
[[nodiscard]] bool calls_hold_up_writes(const Generation&, const Unit&);

/// Whether an argument of the call depends on a variable. Others may write the variable before it is read.
[[nodiscard]] bool reads_variables(const ir::Stmt& call);

}  // namespace robochart::cpp_emit
