// SPDX-License-Identifier: Apache-2.0
// The class that implements lower_expression: one member function per form of the language, in three source files.
// Private to semantics/lower*.
#pragma once

#include "semantics/lower/expressions.hpp"

namespace robochart::ir {

namespace ast = frontend;

/// Lowers the expressions of one context.
class Expressions {
public:
    Expressions(Lowering& lowering, const Names& names) : lowering_(lowering), names_(names) {}

    ExprPtr lower(const ast::Expr& source, TypeId expected = {});

private:
    ExprPtr lower_form(const ast::Expr& source, TypeId expected);
    ExprPtr number(const ast::Expr& source, const std::string& sign);
    ExprPtr name(const ast::Expr& source, TypeId expected);
    ExprPtr literal_by_name(const ast::Expr& source, TypeId expected);
    ExprPtr enum_literal(const ast::Expr& source, const ast::EnumLiteral& literal);
    ExprPtr unary(const ast::Expr& source);
    ExprPtr binary(const ast::Expr& source, TypeId expected);
    ExprPtr compared(Expr expr);
    ExprPtr membership(Expr expr);
    ExprPtr computed(Expr expr, const ast::Expr& source);
    ExprPtr computed_blocks(Expr expr);
    ExprPtr conditional(const ast::Expr& source, TypeId expected);
    void check_bindings(const ast::Expr& source);
    ExprPtr let(const ast::Expr& source, TypeId expected);
    ExprPtr binder(const ast::Expr& source);
    ExprPtr call(const ast::Expr& source, TypeId expected);
    ExprPtr function_call(const ast::Expr& source, const ast::Function& function);
    ExprPtr function_value(const ast::Expr& source, const ast::Function& function);
    ExprPtr toolkit_call(const ast::Expr& source, const ast::Function& function, TypeId expected);
    ExprPtr generic_call(const ast::Expr& source, const ast::Function& function, TypeId expected);
    ExprPtr application(const ast::Expr& source, ExprPtr function);
    ExprPtr member(const ast::Expr& source);
    ExprPtr index(const ast::Expr& source);
    ExprPtr default_of(const ast::Expr& source, TypeId type);
    ExprPtr record(const ast::Expr& source);
    ExprPtr matrix(const ast::Expr& source);
    ExprPtr cast(const ast::Expr& source);
    ExprPtr type_test(const ast::Expr& source);
    ExprPtr range(const ast::Expr& source);
    ExprPtr set_range(const ast::Expr& source);
    ExprPtr transpose(const ast::Expr& source);
    ExprPtr string(const ast::Expr& source);
    ExprPtr result(const ast::Expr& source);
    ExprPtr clock(const ast::Expr& source);
    ExprPtr refuse(const ast::Expr& source, const std::string& what);

    Expr start(const ast::Expr& source, ExprKind kind);
    ExprPtr with_operands(const ast::Expr& source, ExprKind kind);
    ExprPtr operand(const ast::Expr& source, std::size_t place, TypeId expected = {});
    TypeId type_of(const ast::Expr& source);

    Lowering& lowering_;
    const Names& names_;
};

[[nodiscard]] inline ExprPtr share(Expr expr) {
    return std::make_shared<const Expr>(std::move(expr));
}

}  // namespace robochart::ir
