// Where a program may have to wait, so that its code must be able to stop there and go on later.
#pragma once

#include <vector>

#include "cpp_emit/expressions/generation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Whether running the statement can stop half-way: waits, inputs, outputs, calls of defined operations, functions
/// outside their preconditions, and writes that may be held up.
[[nodiscard]] bool suspends(const Generation&, const Unit&, const ir::StmtPtr&);

/// Whether some action of the machine may last beyond a cycle: it suspends, and not only for a wait of 0 or a call of
/// an operation that ends at once.
[[nodiscard]] bool actions_take_time(const Generation&, const Unit&);

/// Whether a transition of the machine has a deadline that counts only while its guard holds (semantics 3.10).
[[nodiscard]] bool guards_deadlines(const ir::Machine&);

/// What the statement evaluates before it does anything, in the order in which the semantics asks for preconditions. An
/// input asks with its value, which is not there yet.
[[nodiscard]] std::vector<const ir::Expr*> evaluated_first(const ir::Stmt&);

/// Whether a thread of the unit that is in front of a call of the platform may hold up writes of others: nothing is
/// propagated to a machine while one of its threads is there, and a variable takes no other write before it is
/// propagated to all machines that require it (semantics 3.7). True where others write at least twice what the unit's
/// machine requires.
[[nodiscard]] bool calls_hold_up_writes(const Generation&, const Unit&);

/// Whether an argument of the call depends on a variable. Before it is read others may write.
[[nodiscard]] bool reads_variables(const ir::Stmt& call);

}  // namespace robochart::cpp_emit
