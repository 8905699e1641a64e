// SPDX-License-Identifier: Apache-2.0
// Traverses expressions, statements and nodes in pre-order.
#include "frontend/syntax/expression_visitor.hpp"

namespace robochart::frontend {

void for_children(const Expr& expr, const std::function<void(const Expr&)>& visit) {
    if (expr.callee) visit(*expr.callee);
    for (const ExprPtr& arg : expr.args)
        if (arg) visit(*arg);
    for (const Binding& binding : expr.bindings)
        if (binding.value) visit(*binding.value);
}

void walk_tree(const Expr& expr, const std::function<void(const Expr&)>& visit) {
    visit(expr);
    for_children(expr, [&](const Expr& child) { walk_tree(child, visit); });
}

void walk_tree(const Stmt& statement, const std::function<void(const Stmt&)>& visit) {
    visit(statement);
    for (const StmtPtr& inner : statement.body) walk_tree(*inner, visit);
}

void for_expressions(const Stmt& statement, const std::function<void(const Expr&)>& visit) {
    for (const ExprPtr* expr : {&statement.condition, &statement.target, &statement.value, &statement.upper})
        if (*expr) visit(**expr);
    for (const ExprPtr& arg : statement.args) visit(*arg);
    if (!statement.communication) return;
    if (statement.communication->value) visit(*statement.communication->value);
    if (statement.communication->predicate) visit(*statement.communication->predicate);
}

void walk_tree(const NodeContainer& top, const std::function<void(const NodeContainer&)>& visit) {
    visit(top);
    for (const auto& node : top.nodes) walk_tree(*node, visit);
}

void for_actions(const NodeContainer& top, const std::function<void(const Stmt&)>& visit) {
    walk_tree(top, [&](const NodeContainer& container) {
        for (const auto& node : container.nodes)
            for (const Action& action : node->actions)
                if (action.statement) visit(*action.statement);
        for (const auto& transition : container.transitions)
            if (transition->action) visit(*transition->action);
    });
}

void for_transitions(const NodeContainer& top, const std::function<void(const Transition&)>& visit) {
    walk_tree(top, [&](const NodeContainer& container) {
        for (const auto& transition : container.transitions) visit(*transition);
    });
}

void for_states(const NodeContainer& top, const std::function<void(const State&)>& visit) {
    walk_tree(top, [&](const NodeContainer& container) {
        for (const auto& node : container.nodes)
            if (node->kind == DeclKind::state) visit(*node);
    });
}

}  // namespace robochart::frontend
