// SPDX-License-Identifier: Apache-2.0
// Implements helpers that the lints share: the transitions by their ends, the effects of actions, and searches for
// variables in expressions.
#include <algorithm>
#include <cstdlib>

#include "frontend/lint/lints.hpp"
#include "frontend/syntax/expression_visitor.hpp"
#include "frontend/types/typer.hpp"

namespace robochart::frontend {

Graph::Graph(const NodeContainer& container) {
    for (const auto& transition : container.transitions) {
        if (transition->source == nullptr || transition->target == nullptr) continue;
        out_[transition->source].push_back(transition.get());
        in_[transition->target].push_back(transition.get());
    }
}

const std::vector<const Transition*>& Graph::transitions_at(const Table& table, const State& node) {
    static const std::vector<const Transition*> none;
    const auto found = table.find(&node);
    return found != table.end() ? found->second : none;
}

const Declaration* assigned_root(const Expr& target) {
    const Expr* root = &target;
    while ((root->kind == ExprKind::member || root->kind == ExprKind::index || root->kind == ExprKind::parenthesised) &&
           root->args[0])
        root = root->args[0].get();
    return root->kind == ExprKind::name ? root->target : nullptr;
}

namespace {

/// False for `wait(0)` and `wait([0,0])`, which take no time.
bool takes_time(const Stmt& wait) {
    const Expr* longest = wait.upper ? wait.upper.get() : wait.value.get();
    return longest == nullptr || longest->kind != ExprKind::integer ||
           longest->text.find_first_not_of('0') != std::string::npos;
}

void add_effect(const Stmt& statement, Effects& effects) {
    switch (statement.kind) {
        case StmtKind::assignment:
            if (statement.target) effects.writes.insert(assigned_root(*statement.target));
            break;
        case StmtKind::communication:
            effects.communicates = true;
            if (statement.communication->variable_target != nullptr)
                effects.writes.insert(statement.communication->variable_target);
            break;
        case StmtKind::call:
            effects.calls = true;
            break;
        case StmtKind::wait:
        case StmtKind::wait_interval:
            effects.waits = effects.waits || takes_time(statement);
            break;
        case StmtKind::clock_reset:
            effects.writes.insert(statement.declaration);
            break;
        case StmtKind::exec:
            effects.waits = true;
            break;
        case StmtKind::skip:
        case StmtKind::sequence:
        case StmtKind::if_then_else:
        case StmtKind::deadline:
        case StmtKind::parenthesised:
        case StmtKind::error:
            break;
    }
}

}  // namespace

void add_effects(const Stmt& action, Effects& effects) {
    walk_tree(action, [&](const Stmt& statement) { add_effect(statement, effects); });
}

void add_effects(const State& state, bool during, Effects& effects) {
    for (const Action& action : state.actions)
        if (action.statement && (during || action.kind != ActionKind::during)) add_effects(*action.statement, effects);
    for (const auto& node : state.nodes) add_effects(*node, during, effects);
    for (const auto& transition : state.transitions) {
        for (const auto& reset : transition->resets) effects.writes.insert(reset.clock);
        if (transition->trigger && transition->trigger->variable_target != nullptr)
            effects.writes.insert(transition->trigger->variable_target);
        if (transition->action) add_effects(*transition->action, effects);
    }
}

bool mentions_any(const Expr& expr, const std::unordered_set<const Declaration*>& declarations) {
    bool found = false;
    walk_tree(expr, [&](const Expr& part) {
        found = found || (part.target != nullptr && declarations.contains(part.target));
    });
    return found;
}

std::optional<double> number_of(const Expr& written) {
    const Expr& expr = strip_parentheses(written);
    if (expr.kind != ExprKind::integer && expr.kind != ExprKind::real) return std::nullopt;
    return std::strtod(expr.text.c_str(), nullptr);
}

double least_time(const Stmt& statement) {
    if (statement.kind == StmtKind::wait || statement.kind == StmtKind::wait_interval)
        return statement.value ? number_of(*statement.value).value_or(0) : 0;
    if (statement.kind == StmtKind::if_then_else) {
        if (statement.body.size() < 2) return 0;
        return std::min(least_time(*statement.body[0]), least_time(*statement.body[1]));
    }
    double sum = 0;
    for (const StmtPtr& inner : statement.body) sum += least_time(*inner);
    return sum;
}

std::string list_names(const std::vector<std::string>& names) {
    std::string result;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) result += i + 1 == names.size() ? " and " : ", ";
        result += "`" + names[i] + "`";
    }
    return result;
}

}  // namespace robochart::frontend
