// SPDX-License-Identifier: Apache-2.0
// See rewrite.hpp.
#include "prism/checks/rewrite.hpp"

#include <unordered_set>

namespace robochart::prism {

ExprPtr Rewriter::operator()(const ExprPtr& expr) {
    done_.clear();
    return rewrite_expression(expr);
}

ExprPtr Rewriter::rewrite_expression(const ExprPtr& expr) {
    if (!expr) return expr;
    if (expr->op == Op::name) {
        const auto found = expressions.find(expr->text);
        return found == expressions.end() ? expr : found->second;
    }
    if (const auto known = done_.find(expr.get()); known != done_.end()) return known->second;
    Expr copy = *expr;
    for (ExprPtr& part : copy.parts) part = rewrite_expression(part);
    if (copy.query) {
        auto query = std::make_shared<Query>(*copy.query);
        query->bound = rewrite_expression(query->bound);
        query->reward_index = rewrite_expression(query->reward_index);
        copy.query = std::move(query);
    }
    if (copy.steps) {
        auto steps = std::make_shared<StepBound>(*copy.steps);
        steps->low = rewrite_expression(steps->low);
        steps->high = rewrite_expression(steps->high);
        copy.steps = std::move(steps);
    }
    if (copy.op == Op::call)
        if (const auto found = functions.find(copy.text); found != functions.end()) copy.text = found->second;
    ExprPtr result = make_expr(std::move(copy));
    done_.emplace(expr.get(), result);
    return result;
}

namespace {

void visit_names(const ExprPtr& expr, const std::function<void(const Expr&)>& visit,
                 std::unordered_set<const Expr*>& seen) {
    if (!expr || !seen.insert(expr.get()).second) return;
    if (expr->op == Op::name) visit(*expr);
    for (const ExprPtr& part : expr->parts) visit_names(part, visit, seen);
    if (expr->query) {
        visit_names(expr->query->bound, visit, seen);
        visit_names(expr->query->reward_index, visit, seen);
    }
    if (expr->steps) {
        visit_names(expr->steps->low, visit, seen);
        visit_names(expr->steps->high, visit, seen);
    }
}

}  // namespace

void for_each_name(const ExprPtr& expr, const std::function<void(const Expr&)>& visit) {
    std::unordered_set<const Expr*> seen;
    visit_names(expr, visit, seen);
}

}  // namespace robochart::prism
