// SPDX-License-Identifier: Apache-2.0
// Implements helpers that construct expressions, and conversions between number types.
#include <algorithm>

#include "semantics/ir/visit.hpp"
#include "semantics/lower/expression_lowering.hpp"
#include "semantics/lower/expressions.hpp"
#include "semantics/lower/types.hpp"

namespace robochart::ir {
namespace {

bool mentions_kind(const ExprPtr& expr, ExprKind a, ExprKind b) {
    bool found = false;
    if (expr) visit_operands(*expr, [&](const Expr& part) { found = found || part.kind == a || part.kind == b; });
    return found;
}

bool builds_from_elements(ExprKind kind) {
    return kind == ExprKind::sequence || kind == ExprKind::set || kind == ExprKind::matrix;
}

/// Converts a relation or function written as a set of pairs, or a set or sequence, to the expected type.
ExprPtr coerce_set_of_pairs(Lowering& lowering, const Expr& expr, TypeId expected) {
    Type pair;
    pair.kind = TypeKind::product;
    pair.args = lowering.system.type(expected).args;
    const TypeId pair_type = intern_type(lowering, pair);
    Expr result = expr;
    result.type = expected;
    for (auto& arg : result.args) arg = coerce_to_type(lowering, arg, pair_type);
    return share_expression(std::move(result));
}

ExprPtr number_literal(const Expr& literal, TypeId type) {
    Expr result = literal;
    result.type = type;
    if (type == real_type) {
        result.kind = ExprKind::real;
        result.decimal = {literal.number, 0};
        result.number = 0;
    }
    return share_expression(std::move(result));
}

ExprPtr cast_to(const ExprPtr& expr, TypeId type) {
    Expr result;
    result.kind = ExprKind::cast;
    result.type = type;
    result.span = expr->span;
    result.args = {expr};
    return share_expression(std::move(result));
}

/// Returns the types of the parts of a value: components of a tuple, elements of a collection, or pairs of a function.
std::vector<TypeId> part_types(const System& system, TypeId id) {
    const Type& type = system.type(id);
    if (type.kind == TypeKind::set) {
        const Type& element = system.type(type.args.at(0));
        if (element.kind == TypeKind::product && element.args.size() == 2) return element.args;
    }
    if (type.kind != TypeKind::vector && type.kind != TypeKind::matrix) return type.args;
    std::size_t count = 1;
    for (const std::int64_t size : type.sizes) count *= static_cast<std::size_t>(size);
    return std::vector<TypeId>(count, type.args.at(0));
}

/// Converts the parts of a literal to the element types of the composed type, one per part.
ExprPtr coerce_parts(Lowering& lowering, const ExprPtr& expr, TypeId expected) {
    const auto args =
        expr->kind == ExprKind::tuple ? part_types(lowering.system, expected) : lowering.system.type(expected).args;
    Expr result = *expr;
    result.type = expected;
    for (std::size_t i = 0; i < result.args.size(); ++i) {
        const std::size_t place = expr->kind == ExprKind::tuple ? i : 0;
        if (place < args.size()) result.args[i] = coerce_to_type(lowering, result.args[i], args[place]);
    }
    return share_expression(std::move(result));
}

/// True if values of the two types have different representations: a whole number in the place of a real, or a sequence
/// in the place of the set of its pairs.
bool written_differently(const System& system, TypeId from, TypeId to) {
    if (from == to || !from.is_valid() || !to.is_valid()) return false;
    if (to == real_type) return is_number(from);
    const TypeKind source = system.type(from).kind;
    const TypeKind target = system.type(to).kind;
    if (source == TypeKind::sequence && is_set_like(target)) return true;
    if (source == TypeKind::record || target == TypeKind::record) return false;
    const auto a = part_types(system, from);
    const auto b = part_types(system, to);
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        if (written_differently(system, a[i], b[i])) return true;
    return false;
}

}  // namespace

ExprPtr coerce_to_type(Lowering& lowering, const ExprPtr& expr, TypeId expected) {
    const bool composed = builds_from_elements(expr->kind) || expr->kind == ExprKind::tuple;
    if (!expected.is_valid() || (expr->type == expected && !composed)) return expr;
    const TypeKind kind = lowering.system.type(expected).kind;
    const bool pairs = kind == TypeKind::relation || kind == TypeKind::function;
    if (expr->kind == ExprKind::integer && is_number(expected)) return number_literal(*expr, expected);
    const bool listed = lowering.system.type(expr->type).kind == TypeKind::sequence;
    if (listed && (pairs || kind == TypeKind::set)) return cast_to(expr, expected);
    if (pairs && expr->kind == ExprKind::set) return coerce_set_of_pairs(lowering, *expr, expected);
    if (composed) return coerce_parts(lowering, expr, expected);
    return written_differently(lowering.system, expr->type, expected) ? cast_to(expr, expected) : expr;
}

ExprPtr make_boolean(bool value, diagnostics::Span span) {
    Expr expr;
    expr.kind = ExprKind::boolean;
    expr.type = boolean_type;
    expr.number = value ? 1 : 0;
    expr.span = span;
    return share_expression(std::move(expr));
}

ExprPtr make_conjunction(const ExprPtr& left, const ExprPtr& right) {
    if (!left || !right) return left ? left : right;
    Expr expr;
    expr.kind = ExprKind::conjunction;
    expr.type = boolean_type;
    expr.span = diagnostics::join_spans(left->span, right->span);
    expr.args = {left, right};
    return share_expression(std::move(expr));
}

ExprPtr make_negation(const ExprPtr& operand) {
    Expr expr;
    expr.kind = ExprKind::logical_not;
    expr.type = boolean_type;
    expr.span = operand->span;
    expr.args = {operand};
    return share_expression(std::move(expr));
}

bool mentions_time(const ExprPtr& expr) {
    return mentions_kind(expr, ExprKind::since, ExprKind::since_entry);
}

bool mentions_trigger_value(const ExprPtr& expr) {
    return mentions_kind(expr, ExprKind::trigger_value, ExprKind::trigger_value);
}

}  // namespace robochart::ir
