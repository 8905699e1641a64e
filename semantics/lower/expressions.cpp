// SPDX-License-Identifier: Apache-2.0
// Lowers literals and names, and dispatches expressions by their form.
#include <algorithm>

#include "semantics/ir/numbers.hpp"
#include "semantics/lower/expression_lowering.hpp"
#include "semantics/lower/types.hpp"
#include "semantics/rules.hpp"

namespace robochart::ir {

/// Returns a node of this form. Its type is the one that the front end computed, or boolean if there is none.
Expr Expressions::start_node(const ast::Expr& source, ExprKind kind) {
    Expr expr;
    expr.kind = kind;
    expr.span = source.span;
    expr.type = source.type ? type_of(source) : boolean_type;
    return expr;
}

TypeId Expressions::type_of(const ast::Expr& source) {
    return lower_type(lowering_, source.type, source.span);
}

ExprPtr Expressions::reject_construct(const ast::Expr& source, const std::string& what) {
    lowering_.report_unsupported(what, source.span);
    return make_boolean(true, source.span);
}

ExprPtr Expressions::lower_operand(const ast::Expr& source, std::size_t place, TypeId expected) {
    if (place < source.args.size() && source.args[place]) return lower(*source.args[place], expected);
    lowering_.report_unresolved("an operand", source.span);
    return make_boolean(true, source.span);
}

ExprPtr Expressions::with_operands(const ast::Expr& source, ExprKind kind) {
    Expr expr = start_node(source, kind);
    for (std::size_t i = 0; i < source.args.size(); ++i) expr.args.push_back(lower_operand(source, i));
    const TypeId type = expr.type;
    return coerce_to_type(lowering_, share_expression(std::move(expr)), type);
}

/// Lowers `{a to b}`. Between two reals, the set contains the reals of the finite type. Between whole numbers, it
/// contains all whole numbers.
ExprPtr Expressions::set_range(const ast::Expr& source) {
    Expr expr = start_node(source, ExprKind::set_range);
    const auto element = lowering_.system.type(expr.type).args;
    const TypeId type = element.empty() ? TypeId{} : element[0];
    if (type == real_type) expr.kind = ExprKind::range;
    for (std::size_t i = 0; i < source.args.size(); ++i) expr.args.push_back(lower_operand(source, i, type));
    return share_expression(std::move(expr));
}

ExprPtr Expressions::lower_number(const ast::Expr& source, const std::string& sign) {
    const auto decimal = parse_decimal(sign + source.text);
    if (!decimal) {
        lowering_.diagnostics.report(rules::number_too_large, source.span, {sign + source.text});
        return make_boolean(true, source.span);
    }
    Expr expr;
    expr.span = source.span;
    if (source.kind == ast::ExprKind::real) {
        expr.kind = ExprKind::real;
        expr.type = real_type;
        expr.decimal = *decimal;
    } else {
        expr.kind = ExprKind::integer;
        expr.type = decimal->unscaled < 0 ? integer_type : nat_type;
        expr.number = decimal->unscaled;
    }
    return share_expression(std::move(expr));
}

namespace {

/// Returns the declared type of the declaration that a name refers to, if it is a value with a written type.
ast::TypePtr declared_type(const ast::Declaration& target) {
    const bool has_type = target.kind == ast::DeclKind::variable || target.kind == ast::DeclKind::constant ||
                          target.kind == ast::DeclKind::parameter || target.kind == ast::DeclKind::bound_variable;
    return has_type ? static_cast<const ast::Variable&>(target).type : nullptr;
}

}  // namespace

ExprPtr Expressions::name(const ast::Expr& source, TypeId expected) {
    if (source.target == nullptr) return literal_by_name(source, expected);
    Expr expr = start_node(source, ExprKind::bound);
    if (const auto type = declared_type(*source.target)) expr.type = lower_type(lowering_, type, source.span);
    expr.text = source.target->name;
    expr.variable = look_up(names_.variables, source.target);
    expr.constant = look_up(names_.constants, source.target);
    if (expr.constant.is_valid()) expr.kind = ExprKind::constant;
    if (expr.variable.is_valid()) expr.kind = ExprKind::variable;
    if (source.target == names_.trigger_variable) {
        expr.kind = ExprKind::trigger_value;
        expr.variable = {};
    }
    const ast::DeclKind kind = source.target->kind;
    if (kind == ast::DeclKind::enum_literal)
        return enum_literal(source, static_cast<const ast::EnumLiteral&>(*source.target));
    if (kind == ast::DeclKind::function)
        return function_value(source, static_cast<const ast::Function&>(*source.target));
    const bool declared = kind == ast::DeclKind::variable || kind == ast::DeclKind::constant;
    if (declared && expr.kind == ExprKind::bound)
        lowering_.report_unresolved("'" + source.name.text() + "'", source.span);
    return share_expression(std::move(expr));
}

/// Resolves a name as a literal of the expected type, because names in assertions may be unresolved.
ExprPtr Expressions::literal_by_name(const ast::Expr& source, TypeId expected) {
    const std::string label = source.name.parts.empty() ? "" : source.name.parts.back();
    if (expected.is_valid()) {
        const auto& labels = lowering_.system.type(expected).labels;
        const auto at = std::ranges::find(labels, label);
        if (at != labels.end()) {
            Expr expr;
            expr.kind = ExprKind::enum_literal;
            expr.type = expected;
            expr.text = label;
            expr.number = at - labels.begin();
            expr.span = source.span;
            return share_expression(std::move(expr));
        }
    }
    lowering_.report_unresolved("'" + source.name.text() + "'", source.span);
    return make_boolean(true, source.span);
}

ExprPtr Expressions::enum_literal(const ast::Expr& source, const ast::EnumLiteral& literal) {
    Expr expr;
    expr.kind = ExprKind::enum_literal;
    expr.span = source.span;
    expr.text = literal.name;
    if (literal.parent == nullptr) {
        lowering_.report_unresolved("'" + literal.name + "'", source.span);
        return share_expression(expr);
    }
    const auto& declaration = static_cast<const ast::TypeDeclaration&>(*literal.parent);
    expr.type = lower_declared_type(lowering_, declaration, source.span);
    const Type type = lowering_.system.type(expr.type);
    expr.number = std::ranges::find(type.labels, literal.name) - type.labels.begin();
    const auto place = static_cast<std::size_t>(expr.number);
    for (std::size_t i = 0; place < type.literal_args.size() && i < type.literal_args[place].size(); ++i)
        expr.args.push_back(lower_operand(source, i, type.literal_args[place][i]));
    return share_expression(std::move(expr));
}

ExprPtr Expressions::lower_form(const ast::Expr& source, TypeId expected) {
    switch (source.kind) {
        case ast::ExprKind::integer:
        case ast::ExprKind::real:
            return lower_number(source, "");
        case ast::ExprKind::boolean:
            return make_boolean(source.text == "true", source.span);
        case ast::ExprKind::name:
            return name(source, expected);
        case ast::ExprKind::result:
            return lower_result(source);
        case ast::ExprKind::unary:
            return lower_unary(source);
        case ast::ExprKind::binary:
            return lower_binary(source, expected);
        case ast::ExprKind::if_then_else:
            return lower_conditional(source, expected);
        case ast::ExprKind::let:
            return lower_let(source, expected);
        case ast::ExprKind::forall:
        case ast::ExprKind::exists:
        case ast::ExprKind::exists_unique:
        case ast::ExprKind::lambda:
        case ast::ExprKind::the:
        case ast::ExprKind::set_comprehension:
            return lower_binder(source);
        case ast::ExprKind::cast:
            return lower_cast(source);
        case ast::ExprKind::member:
            return lower_member(source);
        case ast::ExprKind::index:
            return lower_index(source);
        case ast::ExprKind::call:
            return lower_call(source, expected);
        case ast::ExprKind::tuple:
            return with_operands(source, ExprKind::tuple);
        case ast::ExprKind::record:
            return lower_record(source);
        case ast::ExprKind::sequence:
            return with_operands(source, ExprKind::sequence);
        case ast::ExprKind::set:
            return with_operands(source, ExprKind::set);
        case ast::ExprKind::set_range:
            return set_range(source);
        case ast::ExprKind::matrix:
            return lower_matrix(source);
        case ast::ExprKind::since:
        case ast::ExprKind::since_entry:
            return lower_clock(source);
        case ast::ExprKind::parenthesised:
            return lower_operand(source, 0, expected);
        case ast::ExprKind::string:
            return lower_string(source);
        case ast::ExprKind::to:
        case ast::ExprKind::from:
            return reject_construct(source, "a broadcast's sender or receiver");
        case ast::ExprKind::is_type:
            return type_test(source);
        case ast::ExprKind::range:
            return lower_range(source);
        case ast::ExprKind::inverse:
            return reject_construct(source, "inverse(..), whose entries need not be numbers of a finite type,");
        case ast::ExprKind::transpose:
            return lower_transpose(source);
        case ast::ExprKind::path:
        case ast::ExprKind::probability:
        case ast::ExprKind::reward:
        case ast::ExprKind::all_paths:
        case ast::ExprKind::some_path:
        case ast::ExprKind::in_state:
        case ast::ExprKind::event:
        case ast::ExprKind::marked:
        case ast::ExprKind::simulation:
        case ast::ExprKind::error:
            break;  // mistakes, and forms of probabilistic assertions, which are not lowered
        case ast::ExprKind::register_:
            return lower_register(source);
        case ast::ExprKind::cycle:
            return lower_cycle(source);
    }
    lowering_.report_unresolved("an expression", source.span);
    return make_boolean(true, source.span);
}

ExprPtr Expressions::lower(const ast::Expr& source, TypeId expected) {
    lowering_.diagnostics.poll();
    return coerce_to_type(lowering_, lower_form(source, expected), expected);
}

ExprPtr lower_expression(Lowering& lowering, const Names& names, const frontend::Expr& source, TypeId expected) {
    return Expressions(lowering, names).lower(source, expected);
}

}  // namespace robochart::ir
