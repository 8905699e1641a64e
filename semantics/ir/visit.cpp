// SPDX-License-Identifier: Apache-2.0
// Traverses the IR.
#include "semantics/ir/visit.hpp"

#include "semantics/ir/query.hpp"

namespace robochart::ir {
namespace {

void visit_root(const ExprPtr& expr, ExprRole role, const RootVisitor& visitor) {
    if (expr) visitor(*expr, role);
}

void visit_roots(const std::vector<ExprPtr>& exprs, const RootVisitor& visitor) {
    for (const auto& expr : exprs) visit_root(expr, ExprRole::value, visitor);
}

void visit_communication(const Communication& communication, const RootVisitor& visitor) {
    visit_root(communication.value, ExprRole::value, visitor);
    visit_root(communication.predicate, ExprRole::value, visitor);
}

void visit_statement_roots(const Stmt& stmt, const RootVisitor& visitor) {
    const bool timing =
        stmt.kind == StmtKind::wait || stmt.kind == StmtKind::wait_interval || stmt.kind == StmtKind::deadline;
    visit_root(stmt.condition, ExprRole::value, visitor);
    for (const auto& step : stmt.path) visit_root(step, ExprRole::place, visitor);
    visit_root(stmt.value, timing ? ExprRole::time : ExprRole::value, visitor);
    visit_root(stmt.upper, ExprRole::time, visitor);
    visit_communication(stmt.communication, visitor);
    visit_roots(stmt.args, visitor);
}

template <class Context>
void visit_declarations(const Context& context, const RootVisitor& visitor) {
    for (const auto& variable : context.variables) visit_root(variable.initial, ExprRole::value, visitor);
    for (const auto& constant : context.constants) visit_root(constant.value, ExprRole::value, visitor);
}

}  // namespace

void visit_statements(const Stmt& stmt, const StmtVisitor& visitor) {
    visitor(stmt);
    for (const auto& part : stmt.body)
        if (part) visit_statements(*part, visitor);
}

void visit_statements(const Machine& machine, const StmtVisitor& visitor) {
    for (const auto& node : machine.nodes)
        for (const auto* action : {&node.entry, &node.during, &node.exit})
            if (*action) visit_statements(**action, visitor);
    for (const auto& transition : machine.transitions) {
        for (const auto& store : transition.stores) visit_statements(*store, visitor);
        if (transition.action) visit_statements(*transition.action, visitor);
    }
}

void visit_expressions(const Machine& machine, const RootVisitor& visitor) {
    visit_declarations(machine, visitor);
    visit_running(machine, visitor);
    visit_roots(machine.postconditions, visitor);
}

void visit_running(const Machine& machine, const RootVisitor& visitor) {
    visit_statements(machine, [&](const Stmt& stmt) { visit_statement_roots(stmt, visitor); });
    for (const auto& transition : machine.transitions) {
        visit_root(transition.guard, ExprRole::value, visitor);
        visit_root(transition.probability, ExprRole::probability, visitor);
        if (transition.trigger) visit_communication(*transition.trigger, visitor);
        visit_root(transition.deadline, ExprRole::time, visitor);
    }
    visit_roots(machine.preconditions, visitor);
}

void visit_reads(const Machine& machine, const std::function<void(VariableId)>& visitor) {
    visit_running(machine, [&](const Expr& root, ExprRole) {
        visit_operands(root, [&](const Expr& expr) {
            if (expr.kind == ExprKind::variable) visitor(expr.variable);
        });
    });
    visit_statements(machine, [&](const Stmt& stmt) {
        if (stmt.kind == StmtKind::assign && !stmt.path.empty()) visitor(stmt.variable);
    });
}

void visit_expressions(const System& system, const RootVisitor& visitor) {
    for (const auto& machine : system.machines) visit_expressions(machine, visitor);
    for (const auto& controller : system.controllers) visit_declarations(controller, visitor);
    for (const auto& module : system.modules) visit_declarations(module.platform, visitor);
    for (const auto& property : system.properties)
        for (const auto& [name, value] : property.constants)
            visit_root(value, is_cycle_name(name) ? ExprRole::time : ExprRole::value, visitor);
    for (const auto& simulation : system.simulations) visit_root(simulation.cycle.value, ExprRole::time, visitor);
}

void visit_operands(const Expr& expr, const std::function<void(const Expr&)>& visitor) {
    visitor(expr);
    for (const auto& arg : expr.args)
        if (arg) visit_operands(*arg, visitor);
}

bool is_clock(ExprKind kind) {
    return kind == ExprKind::since || kind == ExprKind::since_entry;
}

bool mentions_clock(const Expr& root) {
    bool found = false;
    visit_operands(root, [&](const Expr& expr) { found = found || is_clock(expr.kind); });
    return found;
}

bool reads_clock(const Expr& expr) {
    if (expr.kind == ExprKind::cast && !expr.args.empty() && expr.args[0]) return reads_clock(*expr.args[0]);
    return is_clock(expr.kind);
}

bool is_connective(ExprKind kind) {
    return kind == ExprKind::logical_not || kind == ExprKind::conjunction || kind == ExprKind::disjunction ||
           kind == ExprKind::implies || kind == ExprKind::iff;
}

bool is_comparison(ExprKind kind) {
    return kind >= ExprKind::equal && kind <= ExprKind::less_equal;
}

ClockId clock_of(const Machine& machine, const Expr& expr) {
    if (expr.kind == ExprKind::cast && reads_clock(expr)) return clock_of(machine, *expr.args[0]);
    if (expr.kind == ExprKind::since) return expr.clock;
    if (expr.kind == ExprKind::since_entry)
        for (std::uint32_t i = 0; i < machine.clocks.size(); ++i)
            if (machine.clocks[i].entry_of == expr.node) return ClockId{i};
    return {};
}

}  // namespace robochart::ir
