// SPDX-License-Identifier: Apache-2.0
// Traverses the expressions and statements of the IR, parents before children.
#pragma once

#include <functional>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// The use of an outermost expression.
enum class ExprRole {
    value,  ///< computes a value
    time,   ///< is a whole wait duration, interval bound or deadline
    place,  ///< selects the part of a variable that an assignment changes: a field or an index
    probability,
};
using RootVisitor = std::function<void(const Expr&, ExprRole)>;
using StmtVisitor = std::function<void(const Stmt&)>;

/// Visits the statement and all statements inside it.
void visit_statements(const Stmt&, const StmtVisitor&);
/// Visits all statements of entry, during, exit and transition actions in order, nodes before transitions.
void visit_statements(const Machine&, const StmtVisitor&);
/// Visits the outermost expressions of the machine: initial values, constants, conditions, guards, triggers and
/// statements.
void visit_expressions(const Machine&, const RootVisitor&);
/// Visits the outermost expressions that a running machine evaluates: first the expressions of statements, then the
/// expressions of transitions, then preconditions. The function does not visit initial values and constants, because
/// they are computed before the machine runs. It does not visit postconditions, because they are claims.
void visit_running(const Machine&, const RootVisitor&);
/// Calls the function for each variable that a running machine reads, once per read. An assignment to a part of a
/// variable also reads the variable, because the other parts of the value do not change.
void visit_reads(const Machine&, const std::function<void(VariableId)>&);
/// Visits the outermost expressions of machines, controllers, platforms and properties, but not those of functions.
void visit_expressions(const System&, const RootVisitor&);
/// Visits the expression and all its operands.
void visit_operands(const Expr&, const std::function<void(const Expr&)>&);

/// Returns true for since and sinceEntry.
[[nodiscard]] bool is_clock(ExprKind);
/// Returns true if the expression or one of its operands is a clock.
[[nodiscard]] bool mentions_clock(const Expr&);
/// Returns true for an expression that is a clock: since, sinceEntry, or a cast of since or sinceEntry.
[[nodiscard]] bool reads_clock(const Expr&);
[[nodiscard]] bool is_comparison(ExprKind);
/// Returns true for not, and, or, implies and iff.
[[nodiscard]] bool is_connective(ExprKind);
/// Returns the clock that since or sinceEntry reads, or an invalid id for other expressions.
[[nodiscard]] ClockId clock_of(const Machine&, const Expr&);

}  // namespace robochart::ir
