// SPDX-License-Identifier: Apache-2.0
// Declares the class that implements lower_expression. It has one member function per form of the language, in three
// source files. Private to semantics/lower*.
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
    ExprPtr lower_number(const ast::Expr& source, const std::string& sign);
    ExprPtr name(const ast::Expr& source, TypeId expected);
    ExprPtr literal_by_name(const ast::Expr& source, TypeId expected);
    ExprPtr enum_literal(const ast::Expr& source, const ast::EnumLiteral& literal);
    ExprPtr lower_unary(const ast::Expr& source);
    ExprPtr lower_binary(const ast::Expr& source, TypeId expected);
    ExprPtr lower_comparison(Expr expr);
    ExprPtr lower_membership(Expr expr);
    ExprPtr lower_arithmetic(Expr expr, const ast::Expr& source);
    ExprPtr computed_blocks(Expr expr);
    ExprPtr lower_conditional(const ast::Expr& source, TypeId expected);
    void check_bindings(const ast::Expr& source);
    ExprPtr lower_let(const ast::Expr& source, TypeId expected);
    ExprPtr lower_binder(const ast::Expr& source);
    ExprPtr lower_call(const ast::Expr& source, TypeId expected);
    ExprPtr function_call(const ast::Expr& source, const ast::Function& function);
    ExprPtr function_value(const ast::Expr& source, const ast::Function& function);
    ExprPtr toolkit_call(const ast::Expr& source, const ast::Function& function, TypeId expected);
    ExprPtr generic_call(const ast::Expr& source, const ast::Function& function, TypeId expected);
    ExprPtr lower_application(const ast::Expr& source, ExprPtr function);
    ExprPtr lower_member(const ast::Expr& source);
    ExprPtr lower_index(const ast::Expr& source);
    ExprPtr default_of(const ast::Expr& source, TypeId type);
    ExprPtr lower_record(const ast::Expr& source);
    ExprPtr lower_matrix(const ast::Expr& source);
    ExprPtr lower_cast(const ast::Expr& source);
    ExprPtr type_test(const ast::Expr& source);
    ExprPtr lower_range(const ast::Expr& source);
    ExprPtr set_range(const ast::Expr& source);
    ExprPtr lower_transpose(const ast::Expr& source);
    ExprPtr lower_string(const ast::Expr& source);
    ExprPtr lower_result(const ast::Expr& source);
    ExprPtr lower_clock(const ast::Expr& source);
    ExprPtr lower_register(const ast::Expr& source);
    ExprPtr lower_cycle(const ast::Expr& source);
    ExprPtr read_variable(const ast::Expr& source, VariableId id) const;
    void add_store(const ast::Expr& source, VariableId content);
    ExprPtr reject_construct(const ast::Expr& source, const std::string& what);

    Expr start_node(const ast::Expr& source, ExprKind kind);
    ExprPtr with_operands(const ast::Expr& source, ExprKind kind);
    ExprPtr lower_operand(const ast::Expr& source, std::size_t place, TypeId expected = {});
    TypeId type_of(const ast::Expr& source);

    Lowering& lowering_;
    const Names& names_;
};

[[nodiscard]] inline ExprPtr share_expression(Expr expr) {
    return std::make_shared<const Expr>(std::move(expr));
}

}  // namespace robochart::ir
