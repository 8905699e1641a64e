// SPDX-License-Identifier: Apache-2.0
// Properties that the rules for statements, time and shared variables all need.
#include "csp_emit/machine/rules/statements.hpp"

#include <algorithm>

#include "checker/cspm/syntax/build.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;
using ir::StmtKind;

std::vector<const ir::Expr*> reads(const ir::Stmt& stmt) {
    std::vector<const ir::Expr*> result;
    for (const auto& expr :
         {stmt.condition, stmt.value, stmt.upper, stmt.communication.value, stmt.communication.predicate})
        if (expr) result.push_back(expr.get());
    for (const auto& expr : stmt.args) result.push_back(expr.get());
    for (const auto& expr : stmt.path) result.push_back(expr.get());
    return result;
}

bool stable(const MachineTables& tables, std::uint32_t frame, const ir::Stmt& stmt, bool alone) {
    const auto unsteady = [&](const ir::Expr& part) {
        if (part.kind != ir::ExprKind::variable) return false;
        const Cell& cell = tables.cells[tables.frames[frame].variables.at(part.variable.index)];
        return cell.shared || (!alone && !cell.parameter);
    };
    const auto expressions = reads(stmt);
    return std::ranges::none_of(expressions, [&](const ir::Expr* expr) { return mentions(*expr, unsteady); });
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
    const auto expressions = reads(stmt);
    return std::ranges::none_of(expressions, [&](const ir::Expr* expr) { return mentions(*expr, heavy); });
}

bool defined(const MachineTables& tables, const RunningThread& running, const ir::Stmt& call) {
    return tables.frames.definition(running.frame(), call.operation) != nullptr;
}

bool visible(const MachineTables& tables, const RunningThread& running, const ir::Stmt& stmt) {
    if (stmt.kind == StmtKind::communicate) return true;
    if (stmt.kind == StmtKind::call) return !defined(tables, running, stmt);
    if (stmt.kind == StmtKind::clock_reset) return tables.frames.announced(running.frame(), stmt.clock) != nullptr;
    const Frame& frame = tables.frames[running.frame()];
    return stmt.kind == StmtKind::assign && tables.cells[frame.variables.at(stmt.variable.index)].shared;
}

b::Exprs function_preconditions(const MachineTables& tables, std::uint32_t frame, const ir::Stmt& stmt,
                                const Values& values) {
    b::Exprs conditions;
    for (const ir::Expr* expr : reads(stmt))
        for (auto& condition : preconditions(tables.project(), tables.frames.scope(frame, values), *expr))
            conditions.push_back(condition);
    return conditions;
}

ExprPtr assigned(const MachineTables& tables, std::uint32_t frame, const ir::Stmt& stmt, const Values& values) {
    const Project& project = tables.project();
    const Scope names = tables.frames.scope(frame, values);
    const ir::Variable& variable = tables.frames[frame].machine->variables.at(stmt.variable.index);
    if (stmt.path.empty()) return expression_as(project, names, *stmt.value, variable.type);
    const ExprPtr old = tables.cells.value(tables.frames[frame].variables.at(stmt.variable.index), values);
    b::Exprs path;
    for (const auto& part : stmt.path) path.push_back(expression(project, names, *part));
    return component(project, variable.type, old, path, expression(project, names, *stmt.value));
}

ExprPtr initial_value(MachineTables& tables, std::uint32_t frame, const ir::Variable& variable) {
    const bool own = variable.scope == ir::VariableScope::local && variable.initial;
    return own ? expression_as(tables.project(), tables.frames.scope(frame, {}), *variable.initial, variable.type)
               : tables.defaults.of(variable.type);
}

ExprPtr step(MachineTables& tables, std::uint32_t frame, const ir::Stmt& stmt, const std::string& what) {
    EventMeaning meaning;
    meaning.kind = what.empty() && stmt.kind == StmtKind::assign ? MeaningKind::assignment : MeaningKind::step;
    const std::string text = tables.project().text(stmt.origin.span);
    meaning.text = what + (text.empty() ? stmt.origin.element : text);
    meaning.origin = stmt.origin;
    return tables.events.step(what + std::to_string(frame) + ":" + std::to_string(stmt.point), meaning);
}

Activation stuck(const RunningThread& running) {
    Item blocked = running.head();
    blocked.kind = ItemKind::stuck;
    blocked.cells.clear();
    std::vector<Item> items = {blocked};
    for (const Link* link = running.tail().get(); link != nullptr; link = link->tail.get())
        if (link->head.kind == ItemKind::deadline_end) items.push_back(link->head);
    return running.replace(program_of(items));
}

}  // namespace robochart::csp_emit
