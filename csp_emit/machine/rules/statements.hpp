// SPDX-License-Identifier: Apache-2.0
// Computes properties of a statement in the thread that will execute it (semantics 3.5): what it reads, whether it is
// visible, and which preconditions it has.
#pragma once

#include <vector>

#include "csp_emit/machine/rules/next.hpp"
#include "csp_emit/machine/tables/machine_tables.hpp"

namespace robochart::csp_emit {

/// Returns the expressions that the statement itself evaluates, without those of nested statements.
[[nodiscard]] std::vector<const ir::Expr*> expressions_of(const ir::Stmt&);
/// True if the statement reads only values that other threads and components cannot write. `alone` is true if no other
/// thread runs.
[[nodiscard]] bool is_stable(const MachineTables&, std::uint32_t frame, const ir::Stmt&, bool alone);
/// True if the current value of every variable that the statement reads is a name or a literal. Such a value can be
/// used twice without copying a large expression.
[[nodiscard]] bool reads_only_names(const MachineTables&, std::uint32_t frame, const ir::Stmt&, const Values&);
/// True if the operation that the statement calls is defined in the machine's context.
[[nodiscard]] bool is_defined(const MachineTables&, const RunningThread&, const ir::Stmt& call);
/// True if the statement is an event of the machine's alphabet.
[[nodiscard]] bool is_visible(const MachineTables&, const RunningThread&, const ir::Stmt&);
/// Returns the preconditions of the functions that the statement uses (semantics 3.5).
[[nodiscard]] std::vector<cspm::ExprPtr> function_preconditions(const MachineTables&, std::uint32_t frame,
                                                                const ir::Stmt&, const Values&);
/// Returns the new value of the assigned variable. The statement may replace only one part of it.
[[nodiscard]] cspm::ExprPtr assigned_value(const MachineTables&, std::uint32_t frame, const ir::Stmt&, const Values&);
/// Returns the initial value of a variable: the declared value for a private variable, and the type's default for a
/// required variable (semantics 3.6, 3.7).
[[nodiscard]] cspm::ExprPtr initial_value(MachineTables&, std::uint32_t frame, const ir::Variable&);

/// Returns a hidden step of a statement: `step__.n`.
[[nodiscard]] cspm::ExprPtr hidden_step(MachineTables&, std::uint32_t frame, const ir::Stmt&, const std::string& what);
/// Returns the configuration in which this thread is blocked. Deadlines around the statement still expire: in `S <{d}`,
/// a process that stops time interrupts S after d, in every state of S (semantics 3.10).
[[nodiscard]] Activation block_thread(const RunningThread&);

}  // namespace robochart::csp_emit
