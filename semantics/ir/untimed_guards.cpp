// SPDX-License-Identifier: Apache-2.0
#include "semantics/ir/untimed_guards.hpp"

#include "semantics/ir/visit.hpp"

namespace robochart::ir {
namespace {

/// Bounds for the truth of a part of a condition in the untimed semantics. `upper` is true if the part is true for some
/// values of the clocks. `lower` is true only if the part is true for all values of the clocks. A null pointer means
/// true for `upper` and false for `lower`.
struct Bounds {
    ExprPtr upper, lower;
};

/// Returns a boolean expression that replaces `whole` or a part of it.
ExprPtr make_boolean_expression(const Expr& whole, ExprKind kind, std::vector<ExprPtr> parts, std::int64_t number = 0) {
    Expr result;
    result.kind = kind;
    result.type = whole.type;
    result.span = whole.span;
    result.number = number;
    result.args = std::move(parts);
    return std::make_shared<const Expr>(std::move(result));
}

ExprPtr negate_guard(const ExprPtr& part) {
    return part ? make_boolean_expression(*part, ExprKind::logical_not, {part}) : nullptr;
}

/// Returns the conjunction of upper bounds. Null means true.
ExprPtr upper_conjunction(const Expr& whole, const ExprPtr& left, const ExprPtr& right) {
    if (!left || !right) return left ? left : right;
    return make_boolean_expression(whole, ExprKind::conjunction, {left, right});
}

/// Returns the disjunction of upper bounds. Null means true.
ExprPtr upper_disjunction(const Expr& whole, const ExprPtr& left, const ExprPtr& right) {
    return left && right ? make_boolean_expression(whole, ExprKind::disjunction, {left, right}) : nullptr;
}

/// Returns the disjunction of lower bounds. Null means false.
ExprPtr lower_disjunction(const Expr& whole, const ExprPtr& left, const ExprPtr& right) {
    if (!left || !right) return left ? left : right;
    return make_boolean_expression(whole, ExprKind::disjunction, {left, right});
}

/// Returns the conjunction of lower bounds. Null means false.
ExprPtr lower_conjunction(const Expr& whole, const ExprPtr& left, const ExprPtr& right) {
    return left && right ? make_boolean_expression(whole, ExprKind::conjunction, {left, right}) : nullptr;
}

/// Returns bounds that are correct for both branches, because the condition of `if` may read clocks.
Bounds bounds_of_choice(const Expr& choice, const Bounds& yes, const Bounds& no) {
    const ExprPtr& condition = choice.args[0];
    if (mentions_clock(*condition))
        return {upper_disjunction(choice, yes.upper, no.upper), lower_conjunction(choice, yes.lower, no.lower)};
    const auto chosen = [&](const ExprPtr& one, const ExprPtr& other, std::int64_t otherwise) -> ExprPtr {
        if (!one && !other) return nullptr;
        const auto known = [&](const ExprPtr& part) {
            return part ? part : make_boolean_expression(choice, ExprKind::boolean, {}, otherwise);
        };
        return make_boolean_expression(choice, ExprKind::if_then_else, {condition, known(one), known(other)});
    };
    return {chosen(yes.upper, no.upper, 1), chosen(yes.lower, no.lower, 0)};
}

class Reader {
public:
    explicit Reader(std::vector<ExprPtr>& left_open) : left_open_(left_open) {}

    Bounds bounds_of(const ExprPtr& part) {
        if (!mentions_clock(*part)) return {part, part};
        const auto operand = [&](std::size_t number) { return bounds_of(part->args[number]); };
        if (part->kind == ExprKind::logical_not) {
            const Bounds inner = operand(0);
            return {negate_guard(inner.lower), negate_guard(inner.upper)};
        }
        if (part->kind == ExprKind::if_then_else) {
            if (mentions_clock(*part->args[0])) left_open_.push_back(part->args[0]);
            const Bounds yes = operand(1), no = operand(2);
            return bounds_of_choice(*part, yes, no);
        }
        const bool implies = part->kind == ExprKind::implies;
        if (part->kind != ExprKind::conjunction && part->kind != ExprKind::disjunction && !implies) {
            left_open_.push_back(part);
            return {};
        }
        Bounds left = operand(0);
        const Bounds right = operand(1);
        if (part->kind == ExprKind::conjunction)
            return {upper_conjunction(*part, left.upper, right.upper),
                    lower_conjunction(*part, left.lower, right.lower)};
        if (implies) left = {negate_guard(left.lower), negate_guard(left.upper)};
        return {upper_disjunction(*part, left.upper, right.upper), lower_disjunction(*part, left.lower, right.lower)};
    }

private:
    std::vector<ExprPtr>& left_open_;
};

}  // namespace

UntimedGuard untimed_guard(const ExprPtr& condition) {
    UntimedGuard result;
    if (condition) result.kept = Reader(result.left_open).bounds_of(condition).upper;
    return result;
}

}  // namespace robochart::ir
