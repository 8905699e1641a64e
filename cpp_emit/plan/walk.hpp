// Walks over the IR beside those of semantics/ir/visit.hpp.
#pragma once

#include <functional>

#include "semantics/ir/ir.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::cpp_emit {

struct Component;

using ExprVisitor = std::function<void(const ir::Expr&)>;
using ir::StmtVisitor;

/// The expression and all below it.
void visit(const ir::ExprPtr&, const ExprVisitor&);
/// The statement and all below it.
void visit(const ir::StmtPtr&, const StmtVisitor&);
/// All expressions whose value matters to running code, with their operands: ir::visit_running.
void visit_expressions(const ir::Machine&, const ExprVisitor&);
/// Those of the preconditions of functions that running code asks.
void visit_asked(const Component&, const ir::System&, const ExprVisitor&);
/// Trigger communications of the transitions, then communications of the statements.
void visit_communications(const ir::Machine&, const std::function<void(const ir::Communication&, bool trigger)>&);

/// The clock of sinceEntry(node); invalid if there is none.
[[nodiscard]] ir::ClockId entry_clock(const ir::Machine&, ir::NodeId);

}  // namespace robochart::cpp_emit
