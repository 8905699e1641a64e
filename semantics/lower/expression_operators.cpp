// SPDX-License-Identifier: Apache-2.0
// Lowers operators, conditionals and binders.
#include "semantics/lower/expression_lowering.hpp"
#include "semantics/lower/types.hpp"

namespace robochart::ir {
namespace {

const ast::Expr& without_parentheses(const ast::Expr& expr) {
    const ast::Expr* inner = &expr;
    while (inner->kind == ast::ExprKind::parenthesised && inner->args[0]) inner = inner->args[0].get();
    return *inner;
}

bool is_number_literal(const ast::Expr& expr) {
    return expr.kind == ast::ExprKind::integer || expr.kind == ast::ExprKind::real;
}

ExprKind kind_of(ast::BinaryOp op) {
    switch (op) {
        case ast::BinaryOp::iff:
            return ExprKind::iff;
        case ast::BinaryOp::implies:
            return ExprKind::implies;
        case ast::BinaryOp::disjunction:
            return ExprKind::disjunction;
        case ast::BinaryOp::conjunction:
            return ExprKind::conjunction;
        case ast::BinaryOp::equal:
            return ExprKind::equal;
        case ast::BinaryOp::not_equal:
            return ExprKind::not_equal;
        case ast::BinaryOp::greater:
            return ExprKind::greater;
        case ast::BinaryOp::greater_equal:
            return ExprKind::greater_equal;
        case ast::BinaryOp::less:
            return ExprKind::less;
        case ast::BinaryOp::less_equal:
            return ExprKind::less_equal;
        case ast::BinaryOp::in:
            return ExprKind::is_in;
        case ast::BinaryOp::plus:
            return ExprKind::plus;
        case ast::BinaryOp::minus:
            return ExprKind::minus;
        case ast::BinaryOp::times:
            return ExprKind::times;
        case ast::BinaryOp::divide:
            return ExprKind::divide;
        case ast::BinaryOp::modulus:
            return ExprKind::modulus;
        case ast::BinaryOp::concat:
            return ExprKind::concat;
    }
    return ExprKind::equal;
}
ExprKind binder_kind(ast::ExprKind kind) {
    if (kind == ast::ExprKind::forall) return ExprKind::forall;
    if (kind == ast::ExprKind::exists) return ExprKind::exists;
    if (kind == ast::ExprKind::exists_unique) return ExprKind::exists_unique;
    if (kind == ast::ExprKind::lambda) return ExprKind::lambda;
    if (kind == ast::ExprKind::the) return ExprKind::the;
    return ExprKind::set_comprehension;
}

}  // namespace

/// Lowers a negation. A negated literal becomes one literal, because RoboTool's Neg(5, core_int) may be clipped to 5,
/// although -5 is meant.
ExprPtr Expressions::lower_unary(const ast::Expr& source) {
    const bool negates = source.unary == ast::UnaryOp::negate;
    if (negates && is_number_literal(without_parentheses(*source.args[0]))) {
        Expr literal = *lower_number(without_parentheses(*source.args[0]), "-");
        literal.span = source.span;
        return share_expression(std::move(literal));
    }
    Expr expr = start_node(source, negates ? ExprKind::negate : ExprKind::logical_not);
    expr.args = {lower_operand(source, 0)};
    if (negates && is_number(expr.args[0]->type)) expr.type = wider_type(expr.args[0]->type, integer_type);
    return share_expression(std::move(expr));
}

ExprPtr Expressions::lower_binary(const ast::Expr& source, TypeId expected) {
    Expr expr = start_node(source, kind_of(*source.binary));
    const bool concat = expr.kind == ExprKind::concat;
    expr.args = {lower_operand(source, 0, concat ? expected : TypeId{}),
                 lower_operand(source, 1, concat ? expected : TypeId{})};
    if (concat && expected.is_valid()) expr.type = expected;
    if (expr.kind >= ExprKind::equal && expr.kind <= ExprKind::less_equal) {
        // If the type of one side is not fully known, as that of `id()`, the other side determines the type.
        for (std::size_t i = 0; i < 2; ++i) {
            const TypeId other = expr.args[1 - i]->type;
            if (is_open(lowering_.system, expr.args[i]->type) && !is_open(lowering_.system, other))
                expr.args[i] = lower_operand(source, i, other);
        }
        return lower_comparison(std::move(expr));
    }
    if (expr.kind >= ExprKind::plus && expr.kind <= ExprKind::modulus) return lower_arithmetic(std::move(expr), source);
    return expr.kind == ExprKind::is_in ? lower_membership(std::move(expr)) : share_expression(std::move(expr));
}

/// Lowers a test of membership. A relation, function or sequence is the set of its pairs. Both sides are converted to
/// the wider type.
ExprPtr Expressions::lower_membership(Expr expr) {
    const Type collection = lowering_.system.type(expr.args[1]->type);
    TypeId element = collection.args.empty() ? TypeId{} : collection.args[0];
    if (collection.kind != TypeKind::set && !collection.args.empty()) {
        Type pair;
        pair.kind = TypeKind::product;
        pair.args = collection.args;
        if (collection.kind == TypeKind::sequence) pair.args.insert(pair.args.begin(), nat_type);
        element = intern_type(lowering_, std::move(pair));
    }
    Type set;
    set.kind = TypeKind::set;
    set.args = {common_type(lowering_, element, expr.args[0]->type)};
    expr.args[0] = coerce_to_type(lowering_, expr.args[0], set.args[0]);
    const bool same = set.args[0] == element && collection.kind != TypeKind::sequence;
    if (!same) expr.args[1] = coerce_to_type(lowering_, expr.args[1], intern_type(lowering_, std::move(set)));
    return share_expression(std::move(expr));
}

/// Lowers a comparison. Both sides are converted to the wider type. An empty collection gets the type of the other
/// side.
ExprPtr Expressions::lower_comparison(Expr expr) {
    expr.type = boolean_type;
    const TypeId common = common_type(lowering_, expr.args[0]->type, expr.args[1]->type);
    for (auto& arg : expr.args) arg = coerce_to_type(lowering_, arg, common);
    return share_expression(std::move(expr));
}

/// Lowers arithmetic with RoboChart's types: the result of minus is int or real, of modulus int, and of divide real.
ExprPtr Expressions::lower_arithmetic(Expr expr, const ast::Expr& source) {
    const TypeId left = expr.args[0]->type;
    const TypeId right = expr.args[1]->type;
    if (!is_number(left) || !is_number(right)) {
        if (!source.type) lowering_.report_unresolved("the type of an expression", source.span);
        return computed_blocks(std::move(expr));
    }
    expr.type = wider_type(left, right);
    if (expr.kind == ExprKind::minus || expr.kind == ExprKind::modulus) expr.type = wider_type(expr.type, integer_type);
    if (expr.kind == ExprKind::divide) expr.type = real_type;
    for (auto& arg : expr.args) arg = coerce_to_type(lowering_, arg, expr.type);
    return share_expression(std::move(expr));
}

/// Lowers arithmetic on vectors and matrices, also with a number. The entries of both operands get one type.
ExprPtr Expressions::computed_blocks(Expr expr) {
    const auto entry = [&](TypeId id) {
        const Type& type = lowering_.system.type(id);
        return type.kind == TypeKind::vector || type.kind == TypeKind::matrix ? type.args.at(0) : id;
    };
    const TypeId common = wider_type(entry(expr.args[0]->type), entry(expr.args[1]->type));
    for (auto& arg : expr.args) {
        Type type = lowering_.system.type(arg->type);
        if (type.kind != TypeKind::vector && type.kind != TypeKind::matrix) {
            arg = coerce_to_type(lowering_, arg, common);
            continue;
        }
        type.name.clear();
        type.args = {common};
        arg = coerce_to_type(lowering_, arg, intern_type(lowering_, std::move(type)));
    }
    return share_expression(std::move(expr));
}

ExprPtr Expressions::lower_conditional(const ast::Expr& source, TypeId expected) {
    Expr expr = start_node(source, ExprKind::if_then_else);
    expr.args = {lower_operand(source, 0, boolean_type), lower_operand(source, 1, expected),
                 lower_operand(source, 2, expected)};
    TypeId type = expected.is_valid() ? expected : expr.args[1]->type;
    if (!expected.is_valid()) type = common_type(lowering_, type, expr.args[2]->type);
    expr.type = type;
    for (std::size_t i = 1; i < expr.args.size(); ++i) expr.args[i] = coerce_to_type(lowering_, expr.args[i], type);
    return share_expression(std::move(expr));
}

/// Reports an expression that binds the same name twice.
void Expressions::check_bindings(const ast::Expr& source) {
    std::vector<const ast::Declaration*> variables;
    for (const auto& binding : source.bindings)
        if (binding.variable) variables.push_back(binding.variable.get());
    lowering_.check_unique(variables, "one expression", "variable");
}

ExprPtr Expressions::lower_let(const ast::Expr& source, TypeId expected) {
    check_bindings(source);
    Expr expr = start_node(source, ExprKind::let);
    for (const auto& binding : source.bindings) {
        if (!binding.variable || !binding.value) return reject_construct(source, "a let without a value");
        expr.bound_names.push_back(binding.variable->name);
        expr.args.push_back(lower(*binding.value));
        expr.bound_types.push_back(expr.args.back()->type);
    }
    expr.args.push_back(lower_operand(source, 0, expected));
    expr.type = expr.args.back()->type;
    return share_expression(std::move(expr));
}

/// Lowers a binder. Its args are its predicate (true if absent) and, if there is one, its body.
ExprPtr Expressions::lower_binder(const ast::Expr& source) {
    check_bindings(source);
    Expr expr = start_node(source, binder_kind(source.kind));
    for (const auto& binding : source.bindings) {
        if (!binding.variable) return reject_construct(source, "a binding without a name");
        expr.bound_names.push_back(binding.variable->name);
        expr.bound_types.push_back(lower_type(lowering_, binding.variable->type, binding.variable->span));
    }
    const bool restricted = !source.args.empty() && source.args[0] != nullptr;
    expr.args.push_back(restricted ? lower(*source.args[0]) : make_boolean(true, source.span));
    if (source.args.size() > 1 && source.args[1]) expr.args.push_back(lower(*source.args[1]));
    return share_expression(std::move(expr));
}

}  // namespace robochart::ir
