// SPDX-License-Identifier: Apache-2.0
// Determines when other components may write a shared variable, and the configuration after a write.
#include "csp_emit/machine/rules/shared_variables.hpp"

#include <algorithm>

#include "checker/cspm/syntax/build.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;

namespace {

bool others_write(const MachineTables& tables) {
    const auto& variables = tables.frames.root_frame().variables;
    return std::ranges::any_of(variables, [&](CellId cell) { return tables.cells[cell].shared; });
}

/// True if the statement may contain a part during which no other component may write.
bool may_refuse_writes(const MachineTables& tables, const ir::Stmt& stmt) {
    const auto function = [](const ir::Expr& part) { return part.kind == ir::ExprKind::call; };
    const auto expressions = expressions_of(stmt);
    return stmt.kind == ir::StmtKind::call || (tables.timed() && stmt.kind == ir::StmtKind::deadline) ||
           std::ranges::any_of(expressions, [&](const ir::Expr* expr) { return has_part(*expr, function); }) ||
           std::ranges::any_of(stmt.body, [&](const auto& part) { return may_refuse_writes(tables, *part); });
}

/// True if the current state of the thread prevents writes by other components.
bool refuses_writes(const MachineTables& tables, const RunningThread& running, bool alone) {
    const Item& item = running.head();
    if (item.kind == ItemKind::stuck || item.kind == ItemKind::shown) return true;
    if (item.stmt == nullptr || (item.kind != ItemKind::statement && item.kind != ItemKind::frozen)) return false;
    const bool to_read = item.kind == ItemKind::statement && (!is_stable(tables, running.frame(), *item.stmt, alone) ||
                                                              reads_in_turn(tables, running, *item.stmt));
    if (to_read) return false;
    if (item.stmt->kind == ir::StmtKind::call) return !is_defined(tables, running, *item.stmt);
    if (item.stmt->kind != ir::StmtKind::communicate) return false;
    const Link* next = running.tail().get();
    return next != nullptr && next->head.kind == ItemKind::deadline_end &&
           next->head.stmt->body.at(0).get() == item.stmt;
}

}  // namespace

bool reads_in_turn(const MachineTables& tables, const RunningThread& running, const ir::Stmt& stmt) {
    const auto variable = [](const ir::Expr& part) { return part.kind == ir::ExprKind::variable; };
    return stmt.kind == ir::StmtKind::call && !is_defined(tables, running, stmt) && others_write(tables) &&
           std::ranges::any_of(stmt.args, [&](const auto& arg) { return has_part(*arg, variable); });
}

void left_before(const MachineTables& tables, const ir::StmtPtr& next, ir::NodeId node,
                 const ir::Transition& transition, std::vector<Item>& items) {
    if (!next || !others_write(tables) || !may_refuse_writes(tables, *next)) return;
    Item left;
    left.kind = ItemKind::left;
    left.node = node;
    left.label = "transition " + transition.name;
    items.push_back(left);
}

void left_and_shown(const MachineTables& tables, std::uint32_t frame, const ir::Transition& transition,
                    std::vector<Item>& items) {
    const bool state = tables.machine().nodes[transition.source.index].kind == ir::NodeKind::state;
    if (frame != 0 || !state || tables.context.shown.empty() || !tables.context.shows_states()) return;
    Item left;
    left.kind = ItemKind::shown;
    left.node = transition.source;
    left.label = "transition " + transition.name;
    items.push_back(left);
}

Branch left_branch(MachineTables& tables, const RunningThread& running) {
    const Item& item = running.head();
    const ir::Node& node = tables.frames[running.frame()].machine->nodes[item.node.index];
    EventMeaning meaning;
    meaning.kind = MeaningKind::exited;
    meaning.text = "leave " + node.path;
    meaning.origin = node.origin;
    const std::string step = "left " + std::to_string(running.frame()) + ":" + std::to_string(item.node.index);
    return {
        nullptr, tables.events.step_event(step, meaning), {}, next_configuration(running.replace(running.tail()), {})};
}

std::vector<ExprPtr> external_write_events(const MachineTables& tables) {
    std::vector<ExprPtr> result;
    for (const CellId cell : tables.frames.root_frame().variables)
        if (tables.cells[cell].shared) result.push_back(b::name("set_EXT_" + tables.cells[cell].channel));
    return result;
}

std::vector<Branch> external_writes(const MachineTables& tables, const Activation& config, const View& view) {
    for (const RunningThread& running : view.threads)
        if (refuses_writes(tables, running, view.threads.size() == 1)) return {};
    std::vector<Branch> result;
    for (const CellId cell : tables.frames.root_frame().variables)
        if (tables.cells[cell].shared)
            result.push_back({nullptr,
                              b::name("set_EXT_" + tables.cells[cell].channel),
                              {b::input("in__")},
                              next_configuration(config, {{cell, b::name("in__")}})});
    return result;
}

}  // namespace robochart::csp_emit
