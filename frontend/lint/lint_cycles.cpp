// SPDX-License-Identifier: Apache-2.0
// Reports two mistakes that occur in published RoboSim models: a store under `not`, and a state from which no `exec` is
// reached. Only `exec` ends a cycle, so time stops in such a state.
#include <algorithm>

#include "frontend/lint/lints.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

namespace {

/// Reports `$e?v` under `not`. When the transition is taken, v is overwritten although the register may be empty.
void check_stores(const Expr& expr, bool negated, Diagnostics& out) {
    const bool stores = expr.kind == ExprKind::register_ && !expr.args.empty();
    if (negated && stores) out.report(rules::not_store, expr.span, {to_text(expr)});
    const bool inside = negated || (expr.kind == ExprKind::unary && expr.unary == UnaryOp::logical_not);
    for_children(expr, [&](const Expr& child) { check_stores(child, inside, out); });
}

/// True if the statement may end the cycle. A call may always end it.
bool may_end_cycle(const Stmt& statement) {
    bool found = false;
    walk_tree(statement, [&](const Stmt& part) {
        found = found || part.kind == StmtKind::exec || (part.kind == StmtKind::call && !part.through_register);
    });
    return found;
}

bool may_end_cycle(const Transition& transition) {
    return transition.exec || (transition.action && may_end_cycle(*transition.action));
}

/// True if an action of the state, or of a state or transition inside it, may end the cycle.
bool may_end_cycle(const State& state) {
    const auto acts = [](const Action& action) { return action.statement && may_end_cycle(*action.statement); };
    return std::ranges::any_of(state.actions, acts) ||
           std::ranges::any_of(state.nodes, [](const auto& node) { return may_end_cycle(*node); }) ||
           std::ranges::any_of(state.transitions, [](const auto& transition) { return may_end_cycle(*transition); });
}

/// True if the cycle can end on some path from the node along the transitions of its container. A final node counts as
/// an end: the machine terminates, or the operation returns.
bool reaches_end(const Graph& graph, const State& start) {
    std::unordered_set<const State*> seen{&start};
    std::vector<const State*> open{&start};
    while (!open.empty()) {
        const State* node = open.back();
        open.pop_back();
        if (node->kind == DeclKind::final || may_end_cycle(*node)) return true;
        for (const Transition* way : graph.transitions_from(*node)) {
            if (may_end_cycle(*way)) return true;
            if (seen.insert(way->target).second) open.push_back(way->target);
        }
    }
    return false;
}

}  // namespace

void lint_cycles(const Machine& machine, Diagnostics& out) {
    walk_tree(machine, [&](const NodeContainer& container) {
        for (const auto& transition : container.transitions)
            if (transition->condition) check_stores(*transition->condition, false, out);
    });
    const Graph graph(machine);
    for (const auto& node : machine.nodes)
        if (node->kind == DeclKind::state && !reaches_end(graph, *node))
            out.report(rules::no_exec, node->name_span, {std::string(to_text(node->kind)), node->name});
}

}  // namespace robochart::frontend
