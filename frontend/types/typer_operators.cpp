// SPDX-License-Identifier: Apache-2.0
// Computes the types of operators: `nat - nat` is an int, `/` is always real, `%` has the type of its operands,
// comparisons are on reals, and `*` of vectors is the dot product.
#include "base/diagnostics/spelling.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/types/typer.hpp"

namespace robochart::frontend {

namespace {

bool is_form(const TypePtr& type, TypeForm form) {
    return type->form == form;
}
bool is_free(const TypePtr& type) {
    return is_form(type, TypeForm::any) || is_form(type, TypeForm::variable);
}
bool fits_boolean(const TypePtr& type) {
    return is_compatible(type, make_type(TypeForm::boolean));
}
bool fits_real(const TypePtr& type) {
    return is_compatible(type, make_type(TypeForm::real));
}

bool sizes_match(long a, long b) {
    return a < 0 || b < 0 || a == b;
}

/// Returns the type of a product of numbers, vectors or matrices, or null if the product is undefined.
TypePtr product_type(const TypePtr& left, const TypePtr& right) {
    if (is_number(left) && is_number(right)) return join_types(left, right);
    const bool left_block = is_form(left, TypeForm::vector) || is_form(left, TypeForm::matrix);
    const bool right_block = is_form(right, TypeForm::vector) || is_form(right, TypeForm::matrix);
    const TypePtr element = join_types(left_block ? left->args[0] : left, right_block ? right->args[0] : right);
    if (!element || !is_number(element)) return nullptr;
    if (left_block != right_block) {
        auto scaled = std::make_shared<Type>(left_block ? *left : *right);
        scaled->args = {element};
        return scaled;
    }
    if (!left_block) return nullptr;
    const bool left_vector = is_form(left, TypeForm::vector);
    const bool right_vector = is_form(right, TypeForm::vector);
    // A vector is a column of n rows with one entry. The product of two vectors is the dot product.
    const bool column_first = left_vector && !right_vector;
    if (!sizes_match(column_first ? 1 : left->sizes.back(), right->sizes.front())) return nullptr;
    if (left_vector && right_vector) return element;
    if (left_vector) return make_matrix(element, left->sizes[0], right->sizes[1]);
    if (right_vector) return make_vector(element, left->sizes[0]);
    return make_matrix(element, left->sizes[0], right->sizes[1]);
}

/// Returns the type of a sum or difference of numbers, or of vectors or matrices of equal size.
TypePtr sum_type(const TypePtr& left, const TypePtr& right, bool minus) {
    const TypePtr both = join_types(left, right);
    if (!both) return nullptr;
    if (is_number(both)) return minus && is_form(both, TypeForm::nat) ? make_type(TypeForm::integer) : both;
    const bool block = is_form(both, TypeForm::vector) || is_form(both, TypeForm::matrix);
    return block && is_number(both->args[0]) ? both : nullptr;
}

}  // namespace

TypePtr Typer::type_unary(Expr& expr, Surroundings& around) {
    const TypePtr operand = simplify_type(assign_type(expr.args[0], around));
    const bool negates = *expr.unary == UnaryOp::negate;
    if (!operand || is_free(operand)) return negates ? operand : make_type(TypeForm::boolean);
    const bool block = is_form(operand, TypeForm::vector) || is_form(operand, TypeForm::matrix);
    const bool fits = negates ? is_number(operand) || (block && is_number(operand->args[0])) : fits_boolean(operand);
    if (!fits) finder_.out().report(rules::unary_type, expr.span, {negates ? "-" : "not", to_string(operand)});
    if (!negates) return make_type(TypeForm::boolean);
    if (!fits) return nullptr;
    return is_form(operand, TypeForm::nat) ? make_type(TypeForm::integer) : operand;
}

namespace {

bool is_comparison(const Expr& expr) {
    return expr.kind == ExprKind::binary && *expr.binary >= BinaryOp::equal && *expr.binary <= BinaryOp::less_equal;
}

}  // namespace

diagnostics::Diagnostic& Typer::report_mismatch(const Expr& expr, const TypePtr& left, const TypePtr& right) {
    diagnostics::Diagnostic& finding = finder_.out().report(
        rules::operand_type, expr.span, {std::string(to_text(*expr.binary)), to_string(left), to_string(right)});
    if (is_comparison(expr) && is_comparison(*expr.args[0]))
        finding.notes.push_back({{}, "`a < b < c` is written `a < b /\\ b < c`"});
    if (*expr.binary == BinaryOp::concat && left && right && is_number(left) && is_number(right))
        finding.notes.push_back({{}, "`^` joins sequences; there is no operator for powers: write `x * x`"});
    return finding;
}

TypePtr Typer::reject_mismatch(const Expr& expr, const TypePtr& left, const TypePtr& right) {
    report_mismatch(expr, left, right);
    return nullptr;
}

TypePtr Typer::type_binary(Expr& expr, Surroundings& around) {
    const TypePtr left = simplify_type(assign_type(expr.args[0], around));
    const TypePtr right = simplify_type(assign_type(expr.args[1], around));
    switch (*expr.binary) {
        case BinaryOp::iff:
        case BinaryOp::implies:
        case BinaryOp::disjunction:
        case BinaryOp::conjunction:
            return type_logical(expr, left, right);
        case BinaryOp::equal:
        case BinaryOp::not_equal:
        case BinaryOp::greater:
        case BinaryOp::greater_equal:
        case BinaryOp::less:
        case BinaryOp::less_equal:
            return type_comparison(expr, left, right);
        case BinaryOp::in:
            return type_membership(expr, left, right);
        case BinaryOp::concat:
            return left && right ? type_concatenation(expr, left, right) : nullptr;
        case BinaryOp::plus:
        case BinaryOp::minus:
        case BinaryOp::times:
        case BinaryOp::divide:
        case BinaryOp::modulus:
            break;
    }
    return left && right ? type_arithmetic(expr, left, right) : nullptr;
}

TypePtr Typer::type_logical(Expr& expr, const TypePtr& left, const TypePtr& right) {
    if (left && right && !(fits_boolean(left) && fits_boolean(right))) reject_mismatch(expr, left, right);
    return make_type(TypeForm::boolean);
}

TypePtr Typer::type_comparison(Expr& expr, const TypePtr& left, const TypePtr& right) {
    const TypePtr boolean = make_type(TypeForm::boolean);
    if (!left || !right) return boolean;
    // Comparisons with clocks have separate rules (CE2, TE4).
    for (const ExprPtr& arg : expr.args)
        if (strip_parentheses(*arg).kind == ExprKind::since || strip_parentheses(*arg).kind == ExprKind::since_entry)
            return boolean;
    const bool equality = *expr.binary == BinaryOp::equal || *expr.binary == BinaryOp::not_equal;
    if (equality && !is_compatible(left, right) && !is_compatible(right, left))
        finder_.out().report(rules::compare_type, expr.span, {to_string(left), to_string(right)});
    if (!equality && !(fits_real(left) && fits_real(right))) reject_mismatch(expr, left, right);
    return boolean;
}

TypePtr Typer::type_membership(Expr& expr, const TypePtr& left, const TypePtr& right) {
    const TypePtr boolean = make_type(TypeForm::boolean);
    if (!left || !right || is_free(right)) return boolean;
    const TypePtr set = as_set(right);
    if (set && (is_compatible(left, set->args[0]) || is_compatible(set->args[0], left))) return boolean;
    auto& finding = report_mismatch(expr, left, right);
    if (!is_form(right, TypeForm::sequence) || !is_compatible(left, right->args[0])) return boolean;
    // A sequence is a set of pairs of position and element, but the author probably meant the elements.
    finding.notes.push_back({{},
                             "a sequence is a set of pairs `(| place, element |)`; `ran` of relation_toolkit is the "
                             "set of its elements"});
    finding.fixes.push_back({expr.args[1]->span, "ran(" + to_text(strip_parentheses(*expr.args[1])) + ")",
                             diagnostics::suggestion_verb(false)});
    return boolean;
}

TypePtr Typer::type_arithmetic(Expr& expr, const TypePtr& left, const TypePtr& right) {
    if (is_free(left) || is_free(right)) return is_free(left) ? right : left;
    const bool numbers = is_number(left) && is_number(right);
    TypePtr result;
    if (*expr.binary == BinaryOp::plus) result = sum_type(left, right, false);
    if (*expr.binary == BinaryOp::minus) result = sum_type(left, right, true);
    if (*expr.binary == BinaryOp::times) result = product_type(left, right);
    if (*expr.binary == BinaryOp::divide && numbers) result = make_type(TypeForm::real);
    if (*expr.binary == BinaryOp::modulus && numbers) result = join_types(left, right);
    return result ? result : reject_mismatch(expr, left, right);
}

TypePtr Typer::type_concatenation(Expr& expr, const TypePtr& left, const TypePtr& right) {
    if (is_free(left)) return right;
    const TypePtr both = join_types(left, right);
    const bool text = both && is_form(both, TypeForm::string);
    if (both && (text || is_form(both, TypeForm::sequence) || is_free(both))) return both;
    return reject_mismatch(expr, left, right);
}

}  // namespace robochart::frontend
