// Walks over the expressions and statements of the IR, parents before children.
#pragma once

#include <functional>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// What an expression is there for.
enum class ExprRole {
    value,  ///< anything that computes
    time,   ///< a whole wait duration, interval bound or deadline
    place,  ///< which part of a variable an assignment changes: a field or an index
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
/// Those among them whose value matters to a machine that runs: statements, then transitions, then preconditions.
/// Initial values and constants have been computed before, postconditions are claims.
void visit_running(const Machine&, const RootVisitor&);
/// Each variable that running the machine reads, as often as it does: in its expressions, and where an assignment to a
/// part keeps the rest.
void visit_reads(const Machine&, const std::function<void(VariableId)>&);
/// The outermost expressions of everything but functions: machines, controllers, platforms, properties.
void visit_expressions(const System&, const RootVisitor&);
/// The expression and all its operands.
void visit_operands(const Expr&, const std::function<void(const Expr&)>&);

/// Whether it reads a clock as it is: since, sinceEntry or a cast of one.
[[nodiscard]] bool reads_clock(const Expr&);
[[nodiscard]] bool is_comparison(ExprKind);
/// The clock that since or sinceEntry reads; invalid for other expressions.
[[nodiscard]] ClockId clock_of(const Machine&, const Expr&);

}  // namespace robochart::ir
