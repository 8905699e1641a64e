// SPDX-License-Identifier: Apache-2.0
// Evaluates arithmetic on numbers, and on vectors and matrices entry by entry (semantics 3.13).
#include <algorithm>
#include <stdexcept>

#include "semantics/evaluate/evaluate.hpp"
#include "semantics/evaluate/evaluate_composed.hpp"
#include "semantics/evaluate/evaluator.hpp"
#include "semantics/ir/arithmetic.hpp"

namespace robochart::ir {

namespace {

/// Returns the result before clipping. Returns no value if it does not fit into 64 bits; such a result is outside every
/// carrier.
std::optional<std::int64_t> exact_result(ExprKind kind, bool real, std::int64_t scale, std::int64_t left,
                                         std::int64_t right) {
    if (kind == ExprKind::plus) return checked_add(left, right);
    if (kind == ExprKind::minus) return checked_subtract(left, right);
    if (kind == ExprKind::times) return real ? multiply_divide(left, right, scale) : checked_multiply(left, right);
    if (kind == ExprKind::divide) return real ? multiply_divide(left, scale, right) : floor_divide(left, right);
    if (kind == ExprKind::modulus) return floor_modulus(left, right);
    throw std::logic_error("an operation on numbers without a value");
}

}  // namespace

/// Computes RoboTool's Plus, Minus, ... on numbers of one type.
Value Evaluator::clip_result(const Expr& expr, ExprKind op, TypeId type, const Value& left, const Value& right) {
    const bool divides = op == ExprKind::divide || op == ExprKind::modulus;
    if (divides && right.number == 0) throw_fault(expr, "division by zero");
    const auto result = exact_result(op, kind(type) == TypeKind::real, instantiation_.scale, left.number, right.number);
    if (!result || !in_carrier(system_, instantiation_, type, {*result, {}})) return left;
    return {*result, {}};
}

Value Evaluator::evaluate_arithmetic(const Expr& expr) {
    const Value left = evaluate_operand(expr, 0);
    const Value right = evaluate_operand(expr, 1);
    const bool left_block = is_composed(kind(argument_at(expr, 0).type));
    const bool right_block = is_composed(kind(argument_at(expr, 1).type));
    if (!left_block && !right_block) return clip_result(expr, expr.kind, expr.type, left, right);
    const TypeId entry = entry_type(expr.type);
    if (expr.kind != ExprKind::times) return apply_entrywise(expr, entry, left, right);
    return left_block && right_block ? multiply_blocks(expr, entry, left, right)
                                     : scaled_block(expr, entry, left, right);
}

/// Applies the operator entry by entry.
Value Evaluator::apply_entrywise(const Expr& expr, TypeId entry, const Value& left, const Value& right) {
    if (left.parts.empty()) return clip_result(expr, expr.kind, entry, left, right);
    if (left.parts.size() != right.parts.size()) throw_fault(expr, "the sizes differ");
    Value result;
    for (std::size_t i = 0; i < left.parts.size(); ++i)
        result.parts.push_back(apply_entrywise(expr, entry, left.parts[i], right.parts[i]));
    return result;
}

/// Multiplies every entry by a number. Keeps the order of the operands, because clipping yields the first one.
Value Evaluator::scaled_block(const Expr& expr, TypeId entry, const Value& left, const Value& right) {
    if (left.parts.empty() && right.parts.empty()) return clip_result(expr, ExprKind::times, entry, left, right);
    Value result;
    for (const Value& part : left.parts) result.parts.push_back(scaled_block(expr, entry, part, right));
    if (left.parts.empty())
        for (const Value& part : right.parts) result.parts.push_back(scaled_block(expr, entry, left, part));
    return result;
}

/// Returns the rows of a matrix. A vector is a column.
std::vector<std::vector<Value>> Evaluator::rows_of(const Value& block, TypeId type) {
    std::vector<std::vector<Value>> result;
    for (const Value& part : block.parts)
        result.push_back(kind(type) == TypeKind::vector ? std::vector<Value>{part} : part.parts);
    return result;
}

/// Computes the product of two matrices, or the dot product of two vectors. Sums are computed from the left.
Value Evaluator::multiply_blocks(const Expr& expr, TypeId entry, const Value& left, const Value& right) {
    const TypeId left_type = argument_at(expr, 0).type;
    const bool dot = kind(left_type) == TypeKind::vector && kind(argument_at(expr, 1).type) == TypeKind::vector;
    auto a = rows_of(left, left_type);
    const auto b = rows_of(right, argument_at(expr, 1).type);
    if (dot) a = {left.parts};
    if (a.empty() || b.empty() || a.front().size() != b.size()) throw_fault(expr, "the sizes do not fit");
    const auto entry_at = [&](std::size_t row, std::size_t column) {
        Value sum = clip_result(expr, ExprKind::times, entry, a[row][0], b[0][column]);
        for (std::size_t i = 1; i < b.size(); ++i)
            sum = clip_result(expr, ExprKind::plus, entry, sum,
                              clip_result(expr, ExprKind::times, entry, a[row][i], b[i][column]));
        return sum;
    };
    if (dot) return entry_at(0, 0);
    Value result;
    for (std::size_t row = 0; row < a.size(); ++row) {
        Value line;
        for (std::size_t column = 0; column < b.front().size(); ++column) line.parts.push_back(entry_at(row, column));
        result.parts.push_back(kind(expr.type) == TypeKind::vector ? line.parts.at(0) : std::move(line));
    }
    return result;
}

Value Evaluator::evaluate_transpose(const Expr& expr) {
    const auto a = rows_of(evaluate_operand(expr, 0), argument_at(expr, 0).type);
    Value result;
    for (std::size_t column = 0; column < a.at(0).size(); ++column) {
        Value line;
        for (const auto& row : a) line.parts.push_back(row.at(column));
        result.parts.push_back(std::move(line));
    }
    return result;
}

Value Evaluator::negate_value(const Value& value, TypeId type) {
    Value result;
    for (const Value& part : value.parts) result.parts.push_back(negate_value(part, type));
    if (!result.parts.empty()) return result;
    const auto number = checked_subtract(0, value.number);
    return number && in_carrier(system_, instantiation_, type, {*number, {}}) ? Value{*number, {}} : value;
}

Value Evaluator::evaluate_negation(const Expr& expr) {
    return negate_value(evaluate_operand(expr, 0), entry_type(expr.type));
}

}  // namespace robochart::ir
