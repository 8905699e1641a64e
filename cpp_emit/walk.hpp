// Visits every expression and statement of a machine, in textual order.
#pragma once

#include <functional>

#include "semantics/ir.hpp"

namespace robochart::cpp_emit {

struct Component;

using ExprVisitor = std::function<void(const ir::Expr&)>;
using StmtVisitor = std::function<void(const ir::Stmt&)>;

/// The expression and all below it.
void visit(const ir::ExprPtr&, const ExprVisitor&);
/// The statement and all below it.
void visit(const ir::StmtPtr&, const StmtVisitor&);
/// The expressions of one statement (not of those below it).
void visit_own(const ir::Stmt&, const ExprVisitor&);
/// Entry, during and exit actions of all states, then the transitions' actions.
void visit_statements(const ir::Machine&, const StmtVisitor&);
/// All expressions whose value matters to running code: guards, triggers, actions, deadlines, preconditions.
void visit_expressions(const ir::Machine&, const ExprVisitor&);
/// Those of the preconditions of functions that running code asks.
void visit_asked(const Component&, const ir::System&, const ExprVisitor&);
/// Trigger communications of the transitions, then communications of the statements.
void visit_communications(const ir::Machine&, const std::function<void(const ir::Communication&, bool trigger)>&);

/// The clock that a since or sinceEntry expression reads; invalid for others.
[[nodiscard]] ir::ClockId clock_of(const ir::Machine&, const ir::Expr&);
/// The clock of sinceEntry(node); invalid if there is none.
[[nodiscard]] ir::ClockId entry_clock(const ir::Machine&, ir::NodeId);

}  // namespace robochart::cpp_emit
