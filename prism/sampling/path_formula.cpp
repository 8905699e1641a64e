// SPDX-License-Identifier: Apache-2.0
// See path_formula.hpp.
#include "prism/sampling/path_formula.hpp"

#include "prism/explore/instance.hpp"
#include "prism/sampling/unsampled.hpp"

namespace robochart::prism {
namespace {

/// Converts other labels to names of booleans. Throws Unsampled if the expression contains a query.
ExprPtr state_expression(const ExprPtr& expr) {
    if (expr->op == Op::label)
        return make_expr(Op::name, expr->span, {},
                         expr->text == "deadlock" ? Instance::deadlock_name : Instance::initial_name);
    if (expr->op == Op::filter || (expr->op >= Op::probability && expr->op <= Op::exists_path))
        throw Unsampled("samples do not answer nested queries");
    if (is_temporal(expr->op)) throw Unsampled("finite paths do not decide path formulas inside F, G, U, W and R");
    std::vector<ExprPtr> parts;
    bool same = true;
    for (const ExprPtr& part : expr->parts) {
        parts.push_back(state_expression(part));
        same = same && parts.back() == part;
    }
    return same ? expr : make_expr(expr->op, expr->span, std::move(parts), expr->text);
}

}  // namespace

PathFormula::PathFormula(const ExprPtr& formula, Code& code) : code_(code) {
    root_ = this->add_formula(formula, 0);
}

std::size_t PathFormula::node(Kind kind, std::size_t a, std::size_t b) {
    nodes_.push_back({kind, a, b});
    return nodes_.size() - 1;
}

std::size_t PathFormula::add_until(Until until) {
    untils_.push_back(std::move(until));
    return node(Kind::until, untils_.size() - 1);
}

Code::Root PathFormula::state(const ExprPtr& expr) {
    return code_.compile(state_expression(expr));
}

std::size_t PathFormula::add_formula(const ExprPtr& expr, std::uint64_t begin) {
    if (!is_path(*expr)) {
        const Code::Root root = state(expr);
        return add_until({begin, root, root, {0, 0}, {}});
    }
    return is_temporal(expr->op) ? add_temporal(*expr, begin) : add_connective(*expr, begin);
}

std::size_t PathFormula::add_connective(const Expr& expr, std::uint64_t begin) {
    const std::size_t a = add_formula(expr.parts[0], begin);
    if (expr.op == Op::negation) return node(Kind::negation, a);
    const std::size_t b = add_formula(expr.parts[1], begin);
    if (expr.op == Op::conjunction) return node(Kind::conjunction, a, b);
    if (expr.op == Op::iff) return node(Kind::equivalence, a, b);
    // a | b is !(!a & !b), a => b is !(a & !b).
    const std::size_t left = expr.op == Op::implies ? a : node(Kind::negation, a);
    return node(Kind::negation, node(Kind::conjunction, left, node(Kind::negation, b)));
}

std::size_t PathFormula::add_temporal(const Expr& expr, std::uint64_t begin) {
    if (expr.op == Op::next) return add_formula(expr.parts[0], begin + 1);
    Until made;
    made.begin = begin;
    if (expr.steps) made.steps = step_range(*expr.steps, code_);
    const ExprPtr yes = make_expr(Op::boolean, expr.span, {}, "true");
    const auto all = [&](const ExprPtr& a, const ExprPtr& b) { return make_expr(Op::conjunction, expr.span, {a, b}); };
    const auto no = [&](const ExprPtr& a) { return make_expr(Op::negation, expr.span, {a}); };
    const ExprPtr& a = expr.parts[0];
    const ExprPtr& b = expr.parts.back();
    ExprPtr left = yes;
    ExprPtr right = b;
    if (expr.op == Op::until) left = a;
    if (expr.op == Op::globally) right = no(b);
    if (expr.op == Op::weak_until) {
        left = all(a, no(b));
        right = all(no(a), no(b));
    }
    if (expr.op == Op::release) {
        left = no(a);
        right = no(b);
    }
    made.left = state(left);
    made.right = state(right);
    const std::size_t result = add_until(std::move(made));
    const bool negated = expr.op == Op::globally || expr.op == Op::weak_until || expr.op == Op::release;
    return negated ? node(Kind::negation, result) : result;
}

void PathFormula::start_path() {
    seen_ = 0;
    for (Until& until : untils_) until.holds.reset();
}

void PathFormula::observe_state(StateValues state) {
    for (Until& until : untils_)
        if (!until.holds && seen_ >= until.begin) observe_state(until, state);
    ++seen_;
}

void PathFormula::observe_state(Until& until, StateValues values) const {
    const std::uint64_t step = seen_ - until.begin;
    if (step >= until.steps.from && code_.holds(until.right, values))
        until.holds = true;
    else if ((until.steps.to && step >= *until.steps.to) || !code_.holds(until.left, values))
        until.holds = false;
}

/// Ends a path that repeats: an event that has not happened in any of the repeated states never happens.
void PathFormula::end_in_loop(std::uint64_t period) {
    for (Until& until : untils_)
        if (!until.holds && seen_ >= until.begin + until.steps.from + period) until.holds = false;
}

std::optional<bool> PathFormula::holds(std::size_t node) const {
    const Node& at = nodes_[node];
    if (at.kind == Kind::until) return untils_[at.a].holds;
    const std::optional<bool> a = holds(at.a);
    if (at.kind == Kind::negation) return a ? std::optional(!*a) : a;
    const std::optional<bool> b = holds(at.b);
    if (at.kind == Kind::equivalence) return a && b ? std::optional(*a == *b) : std::nullopt;
    if ((a && !*a) || (b && !*b)) return false;
    return a && b ? std::optional(true) : std::nullopt;
}

}  // namespace robochart::prism
