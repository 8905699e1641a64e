// SPDX-License-Identifier: Apache-2.0
// Reports mistakes in single statements and transitions: duplicate transitions, assignments of a variable to itself,
// and waits that are longer than their deadline.
#include <map>

#include "frontend/lint/lints.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/types/typer.hpp"

namespace robochart::frontend {

namespace {

std::string as_text(const Transition& transition) {
    std::string text = transition.source->name + "\n" + transition.target->name + "\n";
    if (transition.trigger) text += to_text(*transition.trigger);
    if (transition.exec) text += "exec";
    for (const auto& reset : transition.resets) text += "\n#" + reset.name.text();
    if (transition.deadline) text += "\n<{" + to_text(*transition.deadline);
    if (transition.condition) text += "\ncondition " + to_text(strip_parentheses(*transition.condition));
    if (transition.action) text += "\naction " + to_text(*transition.action);
    return text;
}

/// Reports RC-W14. Transitions that are enabled together but have different effects are not duplicates, because they
/// express a choice.
void check_copies(const NodeContainer& container, Diagnostics& out) {
    std::map<std::string, const Transition*> seen;
    for (const auto& transition : container.transitions) {
        if (transition->source == nullptr || transition->target == nullptr || transition->probability) continue;
        const auto [first, fresh] = seen.emplace(as_text(*transition), transition.get());
        if (fresh) continue;
        out.report(rules::w_copy, transition->name_span, {transition->name, first->second->name})
            .notes.push_back({first->second->name_span, "the other one"});
    }
}

/// Reports RC-W16: a statement that waits longer than its deadline.
void check_deadline(const Stmt& statement, Diagnostics& out) {
    if (statement.kind != StmtKind::deadline || !statement.value || statement.body.empty()) return;
    const auto bound = number_of(*statement.value);
    if (!bound || least_time(*statement.body.front()) <= *bound) return;
    out.report(rules::w_deadline, statement.span, {to_text(*statement.body.front()), to_text(*statement.value)});
}

/// Reports RC-W15: a variable that is assigned to itself.
void check_assignment(const Stmt& statement, Diagnostics& out) {
    if (statement.kind != StmtKind::assignment || !statement.target || !statement.value) return;
    const std::string target = to_text(strip_parentheses(*statement.target));
    if (assigned_root(*statement.target) != nullptr && target == to_text(strip_parentheses(*statement.value)))
        out.report(rules::w_self, statement.span, {target});
}

}  // namespace

void lint_statements(const Machine& machine, Diagnostics& out) {
    walk_tree(machine, [&](const NodeContainer& container) { check_copies(container, out); });
    for_actions(machine, [&](const Stmt& action) {
        walk_tree(action, [&](const Stmt& statement) {
            check_deadline(statement, out);
            check_assignment(statement, out);
        });
    });
}

}  // namespace robochart::frontend
