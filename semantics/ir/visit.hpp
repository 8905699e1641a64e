// SPDX-License-Identifier: Apache-2.0
// Traversals of the expressions and statements of the IR, parents before children.
#pragma once

#include <functional>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// The purpose of an expression.
enum class ExprRole {
    value,  ///< computes a value
    time,   ///< is a whole wait duration, interval bound or deadline
    place,  ///< selects the part of a variable that an assignment changes: a field or an index
    probability,
};
using RootVisitor = std::function<void(const Expr&, ExprRole)>;
using StmtVisitor = std::function<void(const Stmt&)>;

/// The statement and all statements inside it.
void visit_statements(const Stmt&, const StmtVisitor&);
/// All statements of entry, during, exit and transition actions, nodes before transitions, in order.
void visit_statements(const Machine&, const StmtVisitor&);
/// The outermost expressions of the machine: initial values, constants, conditions, guards, triggers and statements.
void visit_expressions(const Machine&, const RootVisitor&);
/// The expressions among them that a running machine evaluates: those of statements, then of transitions, then
/// preconditions. Initial values and constants are computed before, and postconditions are claims.
void visit_running(const Machine&, const RootVisitor&);
/// Calls the function for each variable that a running machine reads, once per read: in expressions, and in assignments
/// to a part of a variable, which keep the rest.
void visit_reads(const Machine&, const std::function<void(VariableId)>&);
/// The outermost expressions of everything except functions: machines, controllers, platforms, properties.
void visit_expressions(const System&, const RootVisitor&);
/// The expression and all its operands.
void visit_operands(const Expr&, const std::function<void(const Expr&)>&);

/// True for an expression that is a clock: since, sinceEntry or a cast of one.
[[nodiscard]] bool reads_clock(const Expr&);
[[nodiscard]] bool is_comparison(ExprKind);
/// The clock that since or sinceEntry reads; invalid for other expressions.
[[nodiscard]] ClockId clock_of(const Machine&, const Expr&);

}  // namespace robochart::ir
