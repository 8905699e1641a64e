#include "cpp_emit/walk.hpp"

#include "cpp_emit/component.hpp"

namespace robochart::cpp_emit {

namespace {

void visit_communication(const ir::Communication& communication, const ExprVisitor& visitor) {
    visit(communication.value, visitor);
    visit(communication.predicate, visitor);
}

}  // namespace

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

void visit_own(const ir::Stmt& stmt, const ExprVisitor& visitor) {
    visit(stmt.condition, visitor);
    for (const auto& step : stmt.path) visit(step, visitor);
    visit(stmt.value, visitor);
    visit(stmt.upper, visitor);
    visit_communication(stmt.communication, visitor);
    for (const auto& arg : stmt.args) visit(arg, visitor);
}

void visit_statements(const ir::Machine& machine, const StmtVisitor& visitor) {
    for (const auto& node : machine.nodes) {
        visit(node.entry, visitor);
        visit(node.during, visitor);
        visit(node.exit, visitor);
    }
    for (const auto& transition : machine.transitions) visit(transition.action, visitor);
}

void visit_expressions(const ir::Machine& machine, const ExprVisitor& visitor) {
    visit_statements(machine, [&](const ir::Stmt& stmt) { visit_own(stmt, visitor); });
    for (const auto& transition : machine.transitions) {
        visit(transition.guard, visitor);
        visit(transition.probability, visitor);
        visit(transition.deadline, visitor);
        if (transition.trigger) visit_communication(*transition.trigger, visitor);
    }
    for (const auto& condition : machine.preconditions) visit(condition, visitor);
}

void visit_asked(const Component& component, const ir::System& system, const ExprVisitor& visitor) {
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

ir::ClockId clock_of(const ir::Machine& machine, const ir::Expr& expr) {
    if (expr.kind == ir::ExprKind::since) return expr.clock;
    return expr.kind == ir::ExprKind::since_entry ? entry_clock(machine, expr.node) : ir::ClockId{};
}

}  // namespace robochart::cpp_emit
