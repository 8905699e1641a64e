// SPDX-License-Identifier: Apache-2.0
// Computes properties that the rules for statements, time and shared variables all need.
#include "csp_emit/machine/rules/statements.hpp"

#include <algorithm>

#include "checker/cspm/syntax/build.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;
using ir::StmtKind;

std::vector<const ir::Expr*> expressions_of(const ir::Stmt& stmt) {
    std::vector<const ir::Expr*> result;
    for (const auto& expr :
         {stmt.condition, stmt.value, stmt.upper, stmt.communication.value, stmt.communication.predicate})
        if (expr) result.push_back(expr.get());
    for (const auto& expr : stmt.args) result.push_back(expr.get());
    for (const auto& expr : stmt.path) result.push_back(expr.get());
    return result;
}

bool is_stable(const MachineTables& tables, std::uint32_t frame, const ir::Stmt& stmt, bool alone) {
    const auto unsteady = [&](const ir::Expr& part) {
        if (part.kind != ir::ExprKind::variable) return false;
        const Cell& cell = tables.cells[tables.frames[frame].variables.at(part.variable.index)];
        return cell.shared || (!alone && !cell.parameter);
    };
    const auto expressions = expressions_of(stmt);
    return std::ranges::none_of(expressions, [&](const ir::Expr* expr) { return has_part(*expr, unsteady); });
}

bool reads_only_names(const MachineTables& tables, std::uint32_t frame, const ir::Stmt& stmt, const Values& values) {
    const auto atomic = [](const ExprPtr& value) {
        return value->kind == cspm::ExprKind::name || value->kind == cspm::ExprKind::integer ||
               value->kind == cspm::ExprKind::boolean;
    };
    const auto heavy = [&](const ir::Expr& part) {
        if (part.kind != ir::ExprKind::variable) return false;
        const auto found = values.find(tables.frames[frame].variables.at(part.variable.index));
        return found != values.end() && !atomic(found->second);
    };
    const auto expressions = expressions_of(stmt);
    return std::ranges::none_of(expressions, [&](const ir::Expr* expr) { return has_part(*expr, heavy); });
}

bool is_defined(const MachineTables& tables, const RunningThread& running, const ir::Stmt& call) {
    return tables.frames.find_definition(running.frame(), call.operation) != nullptr;
}

bool is_visible(const MachineTables& tables, const RunningThread& running, const ir::Stmt& stmt) {
    if (stmt.kind == StmtKind::communicate || stmt.kind == StmtKind::exec) return true;
    if (stmt.kind == StmtKind::call) return !is_defined(tables, running, stmt);
    if (stmt.kind == StmtKind::clock_reset)
        return tables.frames.reset_constructor(running.frame(), stmt.clock) != nullptr;
    const Frame& frame = tables.frames[running.frame()];
    if (stmt.kind != StmtKind::assign) return false;
    const Cell& cell = tables.cells[frame.variables.at(stmt.variable.index)];
    return cell.shared || !cell.output.empty();
}

b::Exprs function_preconditions(const MachineTables& tables, std::uint32_t frame, const ir::Stmt& stmt,
                                const Values& values) {
    b::Exprs conditions;
    for (const ir::Expr* expr : expressions_of(stmt))
        for (auto& condition :
             translate_preconditions(tables.project(), tables.frames.make_scope(frame, values), *expr))
            conditions.push_back(condition);
    return conditions;
}

ExprPtr assigned_value(const MachineTables& tables, std::uint32_t frame, const ir::Stmt& stmt, const Values& values) {
    const Project& project = tables.project();
    const Scope names = tables.frames.make_scope(frame, values);
    const ir::Variable& variable = tables.frames[frame].machine->variables.at(stmt.variable.index);
    if (stmt.path.empty()) return expression_as(project, names, *stmt.value, variable.type);
    const ExprPtr old = tables.cells.current_value(tables.frames[frame].variables.at(stmt.variable.index), values);
    b::Exprs path;
    for (const auto& part : stmt.path) path.push_back(translate_expression(project, names, *part));
    return replace_component(project, variable.type, old, path, translate_expression(project, names, *stmt.value));
}

ExprPtr initial_value(MachineTables& tables, std::uint32_t frame, const ir::Variable& variable) {
    const bool own = variable.scope == ir::VariableScope::local && variable.initial;
    return own ? expression_as(tables.project(), tables.frames.make_scope(frame, {}), *variable.initial, variable.type)
               : tables.defaults.value_of(variable.type);
}

ExprPtr hidden_step(MachineTables& tables, std::uint32_t frame, const ir::Stmt& stmt, const std::string& what) {
    EventMeaning meaning;
    meaning.kind = what.empty() && stmt.kind == StmtKind::assign ? MeaningKind::assignment : MeaningKind::step;
    const std::string text = tables.project().model_text(stmt.origin.span);
    meaning.text = what + (text.empty() ? stmt.origin.element : text);
    meaning.origin = stmt.origin;
    return tables.events.step_event(what + std::to_string(frame) + ":" + std::to_string(stmt.point), meaning);
}

Activation block_thread(const RunningThread& running) {
    Item blocked = running.head();
    blocked.kind = ItemKind::stuck;
    blocked.cells.clear();
    std::vector<Item> items = {blocked};
    for (const Link* link = running.tail().get(); link != nullptr; link = link->tail.get())
        if (link->head.kind == ItemKind::deadline_end) items.push_back(link->head);
    return running.replace(program_of(items));
}

}  // namespace robochart::csp_emit
