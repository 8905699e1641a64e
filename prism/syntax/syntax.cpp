// SPDX-License-Identifier: Apache-2.0
// See syntax.hpp.
#include "prism/syntax/syntax.hpp"

#include <algorithm>

namespace robochart::prism {
namespace {

void include_part(Expr& expr, const ExprPtr& part) {
    if (!part) return;
    expr.height = std::max(expr.height, part->height + 1);
    expr.size = std::min(expr.size + part->size, max_size * 2);
}

bool same_query(const Query* a, const Query* b) {
    if (a == nullptr || b == nullptr) return a == b;
    return a->relation == b->relation && a->optimum == b->optimum && a->reward.text == b->reward.text &&
           same_expr(a->bound, b->bound) && same_expr(a->reward_index, b->reward_index);
}

bool same_steps(const StepBound* a, const StepBound* b) {
    if (a == nullptr || b == nullptr) return a == b;
    return a->low_strict == b->low_strict && a->high_strict == b->high_strict && a->single == b->single &&
           same_expr(a->low, b->low) && same_expr(a->high, b->high);
}

}  // namespace

const char* type_name(Type type) {
    if (type == Type::boolean) return "bool";
    return type == Type::integer ? "int" : "double";
}

ExprPtr make_expr(Expr expr) {
    expr.height = 1;
    expr.size = 1;
    for (const ExprPtr& part : expr.parts) include_part(expr, part);
    if (expr.query) {
        include_part(expr, expr.query->bound);
        include_part(expr, expr.query->reward_index);
    }
    if (expr.steps) {
        include_part(expr, expr.steps->low);
        include_part(expr, expr.steps->high);
    }
    return std::make_shared<const Expr>(std::move(expr));
}

ExprPtr make_expr(Op op, Span span, std::vector<ExprPtr> parts, std::string text) {
    Expr expr;
    expr.op = op;
    expr.span = span;
    expr.parts = std::move(parts);
    expr.text = std::move(text);
    return make_expr(std::move(expr));
}

bool is_temporal(Op op) {
    return op >= Op::next && op <= Op::release;
}

bool is_path(const Expr& expr) {
    if (is_temporal(expr.op)) return true;
    const bool connective = expr.op >= Op::implies && expr.op <= Op::negation;
    return connective && std::ranges::any_of(expr.parts, [](const ExprPtr& part) { return is_path(*part); });
}

bool same_expr(const ExprPtr& a, const ExprPtr& b) {
    if (a == b) return true;
    if (!a || !b || a->op != b->op || a->text != b->text) return false;
    return same_query(a->query.get(), b->query.get()) && same_steps(a->steps.get(), b->steps.get()) &&
           std::ranges::equal(a->parts, b->parts, same_expr);
}

}  // namespace robochart::prism
