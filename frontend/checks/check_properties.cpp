// SPDX-License-Identifier: Apache-2.0
// Checks the form of a probabilistic property. It must be a condition or a query. A number, or a path formula without a
// quantifier, is an error.
#include "frontend/checks/checks.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/lexer.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/types/typer.hpp"
#include "frontend/types/types.hpp"

namespace robochart::frontend {

namespace {

bool is_arithmetic(BinaryOp op) {
    return op == BinaryOp::plus || op == BinaryOp::minus || op == BinaryOp::times || op == BinaryOp::divide ||
           op == BinaryOp::modulus;
}

bool is_number(const Expr& expr) {
    switch (expr.kind) {
        case ExprKind::integer:
        case ExprKind::real:
        case ExprKind::string:
            return true;
        case ExprKind::unary:
            return expr.unary == UnaryOp::negate;
        case ExprKind::binary:
            return is_arithmetic(*expr.binary);
        case ExprKind::name: {
            const auto* variable = dynamic_cast<const Variable*>(expr.target);
            return variable != nullptr && variable->type &&
                   !is_compatible(variable->type, make_type(TypeForm::boolean));
        }
        default:
            return false;
    }
}

/// Returns the path formula that is not inside a quantifier, or null if there is none.
const Expr* bare_path(const Expr& expr) {
    const Expr& bare = strip_parentheses(expr);
    if (bare.kind == ExprKind::path) return &bare;
    if (bare.kind != ExprKind::unary && bare.kind != ExprKind::binary && bare.kind != ExprKind::if_then_else)
        return nullptr;
    for (const ExprPtr& arg : bare.args)
        if (const Expr* found = arg ? bare_path(*arg) : nullptr) return found;
    return nullptr;
}

}  // namespace

void check_property(const Expr& property, Diagnostics& out) {
    if (is_number(strip_parentheses(property)))
        out.report(rules::not_a_property, property.span, {shorten_token(to_text(property))});
    else if (const Expr* path = bare_path(property))
        out.report(rules::path_property, path->span, {shorten_token(to_text(*path))});
}

}  // namespace robochart::frontend
