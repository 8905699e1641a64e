// SPDX-License-Identifier: Apache-2.0
// Checks the rules about clocks and deadlines (language reference 2, Time). The typer reports unknown clocks and states
// (TE2, TE3, TS1).
#include <algorithm>

#include "frontend/checks/checks.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/types/type_algebra.hpp"

namespace robochart::frontend {

namespace {

bool is_timed(const Expr& expr) {
    return expr.kind == ExprKind::since || expr.kind == ExprKind::since_entry;
}

const Expr& inner_expression(const Expr& expr) {
    const Expr* at = &expr;
    while (at->kind == ExprKind::parenthesised) at = at->args[0].get();
    return *at;
}

bool is_comparison(const Expr& expr) {
    if (expr.kind != ExprKind::binary) return false;
    const BinaryOp op = *expr.binary;
    return op == BinaryOp::less || op == BinaryOp::less_equal || op == BinaryOp::greater ||
           op == BinaryOp::greater_equal || op == BinaryOp::equal;
}

/// Checks CE2: a clock is compared with a number.
void check_other_side(const Expr& other, Diagnostics& out) {
    const TypePtr type = simplify_type(other.type);
    if (type && !is_compatible(type, make_type(TypeForm::real)))
        out.report(rules::te4_type, other.span, {to_string(type)});
}

/// Checks TE4: clocks are direct operands of comparisons.
void check_condition(const Expr& expr, Diagnostics& out) {
    if (is_timed(expr)) {
        out.report(rules::te4, expr.span, {to_text(expr)});
        return;
    }
    if (!is_comparison(expr)) return for_children(expr, [&](const Expr& child) { check_condition(child, out); });
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        if (is_timed(inner_expression(*expr.args[side])))
            check_other_side(*expr.args[1 - side], out);
        else
            check_condition(*expr.args[side], out);
    }
}

bool mentions_time(const Expr& expr) {
    bool found = false;
    walk_tree(expr, [&](const Expr& part) { found = found || is_timed(part); });
    return found;
}

/// Checks TE5: sinceEntry names a state of the same container as the transition.
void check_entries(const NodeContainer& container, const Expr& expr, Diagnostics& out) {
    walk_tree(expr, [&](const Expr& part) {
        if (part.kind != ExprKind::since_entry || part.target == nullptr) return;
        const bool beside =
            std::ranges::any_of(container.nodes, [&](const auto& node) { return node.get() == part.target; });
        if (!beside) out.report(rules::te5, part.span, {part.name.text()});
    });
}

/// Checks TE1: only the condition of a transition may read clocks.
void check_untimed(const ExprPtr& expr, const std::string& what, Diagnostics& out) {
    if (!expr) return;
    walk_tree(*expr, [&](const Expr& part) {
        if (is_timed(part)) out.report(rules::te1_elsewhere, part.span, {to_text(part), what});
    });
}

void check_transition(const NodeContainer& container, const Transition& transition, Diagnostics& out) {
    if (transition.deadline && !transition.trigger && !transition.legacy_trigger)
        out.report(rules::tt1, transition.deadline->span, {transition.name});
    check_untimed(transition.deadline, "a deadline", out);
    check_untimed(transition.probability, "a probability", out);
    if (transition.trigger) check_untimed(transition.trigger->predicate, "a value that a trigger accepts", out);
    if (!transition.condition) return;
    check_condition(*transition.condition, out);
    check_entries(container, *transition.condition, out);
}

/// Checks TE1: actions do not read clocks.
void check_action(const Stmt& action, Diagnostics& out) {
    walk_tree(action, [&](const Stmt& statement) {
        for_expressions(statement, [&](const Expr& expr) {
            walk_tree(expr, [&](const Expr& part) {
                if (is_timed(part)) out.report(rules::te1, part.span, {to_text(part)});
            });
        });
    });
}

void check_declarations(const Machine& machine, Diagnostics& out) {
    for (const auto& variable : machine.variables) check_untimed(variable->initial, "an initial value", out);
    for (const ExprPtr& condition : machine.preconditions) check_untimed(condition, "a precondition", out);
    for (const ExprPtr& condition : machine.postconditions) check_untimed(condition, "a postcondition", out);
}

}  // namespace

void check_time(const Machine& machine, Diagnostics& out) {
    const Expr* first_timed = nullptr;
    walk_tree(machine, [&](const NodeContainer& container) {
        for (const auto& transition : container.transitions) {
            check_transition(container, *transition, out);
            if (first_timed == nullptr && transition->condition && mentions_time(*transition->condition))
                first_timed = transition->condition.get();
        }
    });
    for_actions(machine, [&](const Stmt& action) { check_action(action, out); });
    check_declarations(machine, out);
    // RoboSim has no untimed semantics.
    if (first_timed != nullptr && machine.dialect == Dialect::robochart)
        out.report(rules::untimed, first_timed->span, {machine.name});
}

}  // namespace robochart::frontend
