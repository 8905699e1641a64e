// SPDX-License-Identifier: Apache-2.0
// Visits the IR, in addition to the visitors of semantics/ir/visit.hpp.
#pragma once

#include <functional>

#include "semantics/ir/ir.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::cpp_emit {

struct Component;

using ExprVisitor = std::function<void(const ir::Expr&)>;
using ir::StmtVisitor;

/// Visits the expression and its subexpressions.
void visit(const ir::ExprPtr&, const ExprVisitor&);
/// Visits the statement and its parts.
void visit(const ir::StmtPtr&, const StmtVisitor&);
/// Visits all expressions that a running machine evaluates (ir::visit_running), and their operands.
void visit_expressions(const ir::Machine&, const ExprVisitor&);
/// Visits the expressions in preconditions that running code tests.
void visit_tested_preconditions(const Component&, const ir::System&, const ExprVisitor&);
/// Visits the triggers of the transitions, then the communications of the statements.
void visit_communications(const ir::Machine&, const std::function<void(const ir::Communication&, bool trigger)>&);

/// Returns the clock that sinceEntry(node) reads; invalid if there is none.
[[nodiscard]] ir::ClockId entry_clock(const ir::Machine&, ir::NodeId);

}  // namespace robochart::cpp_emit
