// SPDX-License-Identifier: Apache-2.0
#include "frontend/cycles/copies.hpp"

#include <algorithm>

#include "frontend/syntax/lexer.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

namespace {

/// Adds `^` to a word that only RoboSim reserves. The printer escapes the words that RoboChart reserves.
std::string escape_word(const std::string& word) {
    return is_reserved(word, Dialect::robosim) && !is_reserved(word) ? "^" + word : word;
}

QualifiedName escape_name(const QualifiedName& name) {
    QualifiedName result;
    std::ranges::transform(name.parts, std::back_inserter(result.parts), escape_word);
    return result;
}

TypeExprPtr copy_type(const TypeExpr& type);

ExprPtr copy_tree(const Expr& expr, const Renaming& renaming);

ExprPtr copy_part(const ExprPtr& part, const Renaming& renaming) {
    return part ? copy_tree(*part, renaming) : nullptr;
}

Binding copy_binding(const Binding& binding, const Renaming& renaming) {
    Binding result;
    result.value = copy_part(binding.value, renaming);
    if (!binding.variable) return result;
    result.variable = std::make_unique<Variable>(binding.variable->kind);
    result.variable->name = escape_word(binding.variable->name);
    if (binding.variable->type_expr) result.variable->type_expr = copy_type(*binding.variable->type_expr);
    return result;
}

ExprPtr copy_tree(const Expr& expr, const Renaming& renaming) {
    auto result = std::make_unique<Expr>();
    result->kind = expr.kind;
    result->text = expr.kind == ExprKind::member ? escape_word(expr.text) : expr.text;
    result->name = escape_name(expr.name);
    result->binary = expr.binary;
    result->unary = expr.unary;
    for (const ExprPtr& arg : expr.args) result->args.push_back(copy_part(arg, renaming));
    result->callee = copy_part(expr.callee, renaming);
    for (const Binding& binding : expr.bindings) result->bindings.push_back(copy_binding(binding, renaming));
    if (expr.type_expr) result->type_expr = copy_type(*expr.type_expr);
    result->lower_closed = expr.lower_closed;
    result->upper_closed = expr.upper_closed;
    result->columns = expr.columns;
    const bool named = expr.kind == ExprKind::name || expr.kind == ExprKind::since_entry;
    if (!named || !renaming) return result;
    const std::string other = renaming(expr);
    if (other.empty()) return result;
    result->name.parts = {other};
    if (expr.kind == ExprKind::since_entry) result->kind = ExprKind::since;
    return result;
}

TypeExprPtr copy_type(const TypeExpr& type) {
    auto result = std::make_unique<TypeExpr>();
    result->kind = type.kind;
    result->name = escape_name(type.name);
    for (const TypeExprPtr& arg : type.args) result->args.push_back(copy_type(*arg));
    for (const ExprPtr& size : type.sizes) result->sizes.push_back(copy_part(size, {}));
    return result;
}

}  // namespace

std::string robosim_name(std::string_view name) {
    return written_name(escape_word(std::string(name)));
}

std::string robosim_name(const QualifiedName& name) {
    return written_name(escape_name(name));
}

std::string robosim_text(const TypeExpr& type) {
    return to_text(*copy_type(type));
}

std::string robosim_text(const Expr& expr, const Renaming& renaming) {
    return to_text(*copy_tree(expr, renaming));
}

bool is_closed(const Expr& expr) {
    switch (expr.kind) {
        case ExprKind::integer:
        case ExprKind::boolean:
        case ExprKind::name:
        case ExprKind::parenthesised:
        case ExprKind::call:
            return true;
        default:
            return false;
    }
}

}  // namespace robochart::frontend
