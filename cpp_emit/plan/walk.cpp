// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/plan/walk.hpp"

#include "cpp_emit/plan/component.hpp"

namespace robochart::cpp_emit {

void visit(const ir::ExprPtr& expr, const ExprVisitor& visitor) {
    if (!expr) return;
    visitor(*expr);
    for (const auto& arg : expr->args) visit(arg, visitor);
}

void visit(const ir::StmtPtr& stmt, const StmtVisitor& visitor) {
    if (!stmt) return;
    visitor(*stmt);
    for (const auto& part : stmt->body) visit(part, visitor);
}

void visit_expressions(const ir::Machine& machine, const ExprVisitor& visitor) {
    ir::visit_running(machine, [&](const ir::Expr& root, ir::ExprRole) { ir::visit_operands(root, visitor); });
}

void visit_tested_preconditions(const Component& component, const ir::System& system, const ExprVisitor& visitor) {
    for (const FunctionHook& hook : component.functions) {
        if (!hook.guarded) continue;
        for (const auto& condition : system.functions[hook.id.index].preconditions) visit(condition, visitor);
    }
}

void visit_communications(const ir::Machine& machine,
                          const std::function<void(const ir::Communication&, bool trigger)>& visitor) {
    for (const auto& transition : machine.transitions)
        if (transition.trigger) visitor(*transition.trigger, true);
    visit_statements(machine, [&](const ir::Stmt& stmt) {
        if (stmt.kind == ir::StmtKind::communicate) visitor(stmt.communication, false);
    });
}

ir::ClockId entry_clock(const ir::Machine& machine, ir::NodeId node) {
    for (std::uint32_t index = 0; index < machine.clocks.size(); ++index)
        if (machine.clocks[index].entry_of == node) return ir::ClockId{index};
    return {};
}

}  // namespace robochart::cpp_emit
