// Expressions, one function per form of the language.
#include "semantics/lower/expressions.hpp"

#include <algorithm>

#include "semantics/lower/types.hpp"
#include "semantics/numbers.hpp"
#include "semantics/rules.hpp"

namespace robochart::ir {
namespace {

namespace ast = frontend;

ExprPtr share(Expr expr) {
    return std::make_shared<const Expr>(std::move(expr));
}

const ast::Expr& strip(const ast::Expr& expr) {
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
    ExprPtr computed(Expr expr, const ast::Expr& source);
    ExprPtr conditional(const ast::Expr& source, TypeId expected);
    ExprPtr let(const ast::Expr& source, TypeId expected);
    ExprPtr binder(const ast::Expr& source);
    ExprPtr call(const ast::Expr& source);
    ExprPtr function_call(const ast::Expr& source, const ast::Function& function);
    ExprPtr application(const ast::Expr& source, ExprPtr function);
    ExprPtr member(const ast::Expr& source);
    ExprPtr index(const ast::Expr& source);
    ExprPtr record(const ast::Expr& source);
    ExprPtr matrix(const ast::Expr& source);
    ExprPtr cast(const ast::Expr& source);
    ExprPtr clock(const ast::Expr& source);
    ExprPtr refuse(const ast::Expr& source, const std::string& what);

    Expr start(const ast::Expr& source, ExprKind kind);
    ExprPtr with_operands(const ast::Expr& source, ExprKind kind);
    ExprPtr operand(const ast::Expr& source, std::size_t place, TypeId expected = {});
    TypeId type_of(const ast::Expr& source);

    Lowering& lowering_;
    const Names& names_;
};

/// A node of this form; its type is the one the front end computed, boolean where it has none.
Expr Expressions::start(const ast::Expr& source, ExprKind kind) {
    Expr expr;
    expr.kind = kind;
    expr.span = source.span;
    expr.type = source.type ? type_of(source) : boolean_type;
    return expr;
}

TypeId Expressions::type_of(const ast::Expr& source) {
    return lower_type(lowering_, source.type, source.span);
}

ExprPtr Expressions::refuse(const ast::Expr& source, const std::string& what) {
    lowering_.unsupported(what, source.span);
    return make_boolean(true, source.span);
}

ExprPtr Expressions::operand(const ast::Expr& source, std::size_t place, TypeId expected) {
    if (place < source.args.size() && source.args[place]) return lower(*source.args[place], expected);
    lowering_.unresolved("an operand", source.span);
    return make_boolean(true, source.span);
}

ExprPtr Expressions::with_operands(const ast::Expr& source, ExprKind kind) {
    Expr expr = start(source, kind);
    for (std::size_t i = 0; i < source.args.size(); ++i) expr.args.push_back(operand(source, i));
    const TypeId type = expr.type;
    return coerce(lowering_, share(std::move(expr)), type);
}

ExprPtr Expressions::number(const ast::Expr& source, const std::string& sign) {
    const auto decimal = parse_decimal(sign + source.text);
    if (!decimal) {
        lowering_.diagnostics.report(rules::number_too_large, source.span, {sign + source.text});
        return make_boolean(true, source.span);
    }
    Expr expr;
    expr.span = source.span;
    const bool real = source.kind == ast::ExprKind::real;
    expr.kind = real ? ExprKind::real : ExprKind::integer;
    expr.type = real ? real_type : decimal->unscaled < 0 ? integer_type : nat_type;
    if (real)
        expr.decimal = *decimal;
    else
        expr.number = decimal->unscaled;
    return share(std::move(expr));
}

template <class Id>
Id look_up(const ByDeclaration<Id>& map, const ast::Declaration* declaration) {
    const auto it = map.find(declaration);
    return it == map.end() ? Id{} : it->second;
}

/// The declared type of what a name stands for, where it is a value with a written type.
ast::TypePtr declared_type(const ast::Declaration& target) {
    switch (target.kind) {
        case ast::DeclKind::variable:
        case ast::DeclKind::constant:
        case ast::DeclKind::parameter:
        case ast::DeclKind::bound_variable:
            return static_cast<const ast::Variable&>(target).type;
        default:
            return nullptr;
    }
}

ExprPtr Expressions::name(const ast::Expr& source, TypeId expected) {
    if (source.target == nullptr) return literal_by_name(source, expected);
    Expr expr = start(source, ExprKind::bound);
    if (const auto type = declared_type(*source.target)) expr.type = lower_type(lowering_, type, source.span);
    expr.text = source.target->name;
    expr.variable = look_up(names_.variables, source.target);
    expr.constant = look_up(names_.constants, source.target);
    if (expr.constant.valid()) expr.kind = ExprKind::constant;
    if (expr.variable.valid()) expr.kind = ExprKind::variable;
    if (source.target == names_.trigger_variable) {
        expr.kind = ExprKind::trigger_value;
        expr.variable = {};
    }
    switch (source.target->kind) {
        case ast::DeclKind::enum_literal:
            return enum_literal(source, static_cast<const ast::EnumLiteral&>(*source.target));
        case ast::DeclKind::function:
            expr.kind = ExprKind::function_value;
            expr.function = lower_function(lowering_, static_cast<const ast::Function&>(*source.target), source.span);
            return share(std::move(expr));
        case ast::DeclKind::variable:
        case ast::DeclKind::constant:
            if (expr.kind == ExprKind::bound) lowering_.unresolved("'" + source.name.text() + "'", source.span);
            break;
        default:
            break;
    }
    return share(std::move(expr));
}

/// In assertions names may be left to us: a literal of the type that is expected.
ExprPtr Expressions::literal_by_name(const ast::Expr& source, TypeId expected) {
    const std::string label = source.name.parts.empty() ? "" : source.name.parts.back();
    if (expected.valid()) {
        const auto& labels = lowering_.system.type(expected).labels;
        const auto at = std::find(labels.begin(), labels.end(), label);
        if (at != labels.end()) {
            Expr expr;
            expr.kind = ExprKind::enum_literal;
            expr.type = expected;
            expr.text = label;
            expr.number = at - labels.begin();
            expr.span = source.span;
            return share(std::move(expr));
        }
    }
    lowering_.unresolved("'" + source.name.text() + "'", source.span);
    return make_boolean(true, source.span);
}

ExprPtr Expressions::enum_literal(const ast::Expr& source, const ast::EnumLiteral& literal) {
    Expr expr;
    expr.kind = ExprKind::enum_literal;
    expr.span = source.span;
    expr.text = literal.name;
    if (literal.parent == nullptr) return lowering_.unresolved("'" + literal.name + "'", source.span), share(expr);
    const auto& declaration = static_cast<const ast::TypeDeclaration&>(*literal.parent);
    expr.type = lower_declared_type(lowering_, declaration, source.span);
    const Type type = lowering_.system.type(expr.type);
    expr.number = std::find(type.labels.begin(), type.labels.end(), literal.name) - type.labels.begin();
    const auto place = static_cast<std::size_t>(expr.number);
    for (std::size_t i = 0; place < type.literal_args.size() && i < type.literal_args[place].size(); ++i)
        expr.args.push_back(operand(source, i, type.literal_args[place][i]));
    return share(std::move(expr));
}

/// A negated literal is one literal: RoboTool's Neg(5, core_int) would be clipped to 5 where -5 is meant.
ExprPtr Expressions::unary(const ast::Expr& source) {
    const bool negates = source.unary == ast::UnaryOp::negate;
    if (negates && is_number_literal(strip(*source.args[0]))) {
        Expr literal = *number(strip(*source.args[0]), "-");
        literal.span = source.span;
        return share(std::move(literal));
    }
    Expr expr = start(source, negates ? ExprKind::negate : ExprKind::logical_not);
    expr.args = {operand(source, 0)};
    if (negates && is_number(expr.args[0]->type)) expr.type = join(expr.args[0]->type, integer_type);
    return share(std::move(expr));
}

ExprPtr Expressions::binary(const ast::Expr& source, TypeId expected) {
    Expr expr = start(source, kind_of(*source.binary));
    const bool concat = expr.kind == ExprKind::concat;
    expr.args = {operand(source, 0, concat ? expected : TypeId{}), operand(source, 1, concat ? expected : TypeId{})};
    if (concat && expected.valid()) expr.type = expected;
    if (expr.kind >= ExprKind::equal && expr.kind <= ExprKind::less_equal) return compared(std::move(expr));
    if (expr.kind >= ExprKind::plus && expr.kind <= ExprKind::modulus) return computed(std::move(expr), source);
    if (expr.kind == ExprKind::is_in) {
        const auto args = lowering_.system.type(expr.args[1]->type).args;
        if (args.size() == 1) expr.args[0] = coerce(lowering_, expr.args[0], args[0]);
    }
    return share(std::move(expr));
}

/// Both sides in the wider type; an empty collection takes the other side's type.
ExprPtr Expressions::compared(Expr expr) {
    expr.type = boolean_type;
    TypeId left = expr.args[0]->type;
    TypeId right = expr.args[1]->type;
    if (is_number(left) && is_number(right)) left = right = join(left, right);
    const bool left_is_literal = expr.args[0]->kind == ExprKind::sequence || expr.args[0]->kind == ExprKind::set ||
                                 expr.args[0]->kind == ExprKind::tuple || expr.args[0]->kind == ExprKind::matrix;
    const TypeId common = left_is_literal ? right : left;
    for (auto& arg : expr.args) arg = coerce(lowering_, arg, common);
    return share(std::move(expr));
}

/// RoboChart's types of arithmetic: minus is int at least, modulus int, divide real.
ExprPtr Expressions::computed(Expr expr, const ast::Expr& source) {
    const TypeId left = expr.args[0]->type;
    const TypeId right = expr.args[1]->type;
    if (!is_number(left) || !is_number(right)) {
        if (!source.type) lowering_.unresolved("the type of an expression", source.span);
        return share(std::move(expr));
    }
    expr.type = join(left, right);
    if (expr.kind == ExprKind::minus || expr.kind == ExprKind::modulus) expr.type = join(expr.type, integer_type);
    if (expr.kind == ExprKind::divide) expr.type = real_type;
    for (auto& arg : expr.args) arg = coerce(lowering_, arg, expr.type);
    return share(std::move(expr));
}

ExprPtr Expressions::conditional(const ast::Expr& source, TypeId expected) {
    Expr expr = start(source, ExprKind::if_then_else);
    expr.args = {operand(source, 0, boolean_type), operand(source, 1, expected), operand(source, 2, expected)};
    TypeId type = expected.valid() ? expected : expr.args[1]->type;
    if (!expected.valid() && is_number(type)) type = join(type, expr.args[2]->type);
    expr.type = type;
    for (std::size_t i = 1; i < expr.args.size(); ++i) expr.args[i] = coerce(lowering_, expr.args[i], type);
    return share(std::move(expr));
}

ExprPtr Expressions::let(const ast::Expr& source, TypeId expected) {
    Expr expr = start(source, ExprKind::let);
    for (const auto& binding : source.bindings) {
        if (!binding.variable || !binding.value) return refuse(source, "a let without a value");
        expr.bound_names.push_back(binding.variable->name);
        expr.args.push_back(lower(*binding.value));
        expr.bound_types.push_back(expr.args.back()->type);
    }
    expr.args.push_back(operand(source, 0, expected));
    expr.type = expr.args.back()->type;
    return share(std::move(expr));
}

ExprKind binder_kind(ast::ExprKind kind) {
    switch (kind) {
        case ast::ExprKind::forall:
            return ExprKind::forall;
        case ast::ExprKind::exists:
            return ExprKind::exists;
        case ast::ExprKind::exists_unique:
            return ExprKind::exists_unique;
        case ast::ExprKind::lambda:
            return ExprKind::lambda;
        case ast::ExprKind::the:
            return ExprKind::the;
        default:
            return ExprKind::set_comprehension;
    }
}

/// args: the predicate (true if absent), then the body if there is one.
ExprPtr Expressions::binder(const ast::Expr& source) {
    Expr expr = start(source, binder_kind(source.kind));
    for (const auto& binding : source.bindings) {
        if (!binding.variable) return refuse(source, "a binding without a name");
        expr.bound_names.push_back(binding.variable->name);
        expr.bound_types.push_back(lower_type(lowering_, binding.variable->type, binding.variable->span));
    }
    const bool restricted = !source.args.empty() && source.args[0] != nullptr;
    expr.args.push_back(restricted ? lower(*source.args[0]) : make_boolean(true, source.span));
    if (source.args.size() > 1 && source.args[1]) expr.args.push_back(lower(*source.args[1]));
    return share(std::move(expr));
}

ExprPtr Expressions::application(const ast::Expr& source, ExprPtr function) {
    Expr expr = start(source, ExprKind::apply);
    expr.args.push_back(std::move(function));
    for (std::size_t i = 0; i < source.args.size(); ++i) expr.args.push_back(operand(source, i));
    return share(std::move(expr));
}

ExprPtr Expressions::function_call(const ast::Expr& source, const ast::Function& function) {
    Expr expr;
    expr.kind = ExprKind::call;
    expr.span = source.span;
    expr.text = function.name;
    expr.function = lower_function(lowering_, function, source.span);
    if (!expr.function.valid()) return make_boolean(true, source.span);
    expr.type = lower_type(lowering_, function.result, source.span);
    for (std::size_t i = 0; i < source.args.size(); ++i) {
        const bool typed = i < function.parameters.size();
        const TypeId type = typed ? lower_type(lowering_, function.parameters[i]->type, source.span) : TypeId{};
        expr.args.push_back(operand(source, i, type));
    }
    return share(std::move(expr));
}

ExprPtr Expressions::call(const ast::Expr& source) {
    if (source.callee) return application(source, lower(*source.callee));
    if (source.target == nullptr) {
        lowering_.unresolved("'" + source.name.text() + "'", source.span);
        return make_boolean(true, source.span);
    }
    if (source.target->kind == ast::DeclKind::function)
        return function_call(source, static_cast<const ast::Function&>(*source.target));
    if (source.target->kind == ast::DeclKind::enum_literal)
        return enum_literal(source, static_cast<const ast::EnumLiteral&>(*source.target));
    ast::Expr callee;
    callee.kind = ast::ExprKind::name;
    callee.span = source.name.span;
    callee.target = source.target;
    return application(source, name(callee, {}));
}

ExprPtr Expressions::member(const ast::Expr& source) {
    Expr expr = start(source, ExprKind::member);
    expr.args = {operand(source, 0)};
    const Type& type = lowering_.system.type(expr.args[0]->type);
    const auto at = std::find(type.labels.begin(), type.labels.end(), source.text);
    if (type.kind != TypeKind::record || at == type.labels.end())
        return lowering_.unresolved("field '" + source.text + "'", source.span), share(std::move(expr));
    expr.number = at - type.labels.begin();
    expr.text = source.text;
    expr.type = type.args[static_cast<std::size_t>(expr.number)];
    return share(std::move(expr));
}

ExprPtr Expressions::index(const ast::Expr& source) {
    Expr expr = start(source, ExprKind::index);
    for (std::size_t i = 0; i < source.args.size(); ++i) expr.args.push_back(operand(source, i));
    const Type& type = lowering_.system.type(expr.args[0]->type);
    if (type.kind != TypeKind::product) return share(std::move(expr));
    const bool fixed = expr.args.size() == 2 && expr.args[1]->kind == ExprKind::integer && expr.args[1]->number >= 1 &&
                       expr.args[1]->number <= static_cast<std::int64_t>(type.args.size());
    if (!fixed) return refuse(source, "a tuple's place that is not a number literal");
    expr.kind = ExprKind::member;
    expr.number = expr.args[1]->number;
    expr.type = type.args[static_cast<std::size_t>(expr.number - 1)];
    expr.args.pop_back();
    return share(std::move(expr));
}

ExprPtr Expressions::record(const ast::Expr& source) {
    Expr expr = start(source, ExprKind::record);
    const Type type = lowering_.system.type(expr.type);
    for (std::size_t i = 0; i < type.labels.size(); ++i) {
        const auto binding = std::find_if(source.bindings.begin(), source.bindings.end(), [&](const ast::Binding& b) {
            return b.variable && b.variable->name == type.labels[i];
        });
        if (binding == source.bindings.end() || !binding->value)
            return refuse(source, "a record without its field " + type.labels[i]);
        expr.args.push_back(lower(*binding->value, type.args[i]));
    }
    return share(std::move(expr));
}

ExprPtr Expressions::matrix(const ast::Expr& source) {
    Expr expr = start(source, ExprKind::matrix);
    for (std::size_t i = 0; i < source.args.size(); ++i) expr.args.push_back(operand(source, i));
    const bool vector = lowering_.system.type(expr.type).kind == TypeKind::vector;
    expr.number = vector ? 1 : static_cast<std::int64_t>(source.columns);
    return share(std::move(expr));
}

ExprPtr Expressions::cast(const ast::Expr& source) {
    if (!source.type_expr) return refuse(source, "a cast without a type");
    const TypeId type = lower_type(lowering_, source.type_expr->type, source.span);
    const ExprPtr value = operand(source, 0, type);
    if (value->type == type) return value;
    Expr expr;
    expr.kind = ExprKind::cast;
    expr.span = source.span;
    expr.type = type;
    expr.args = {value};
    return share(std::move(expr));
}

/// The clock behind sinceEntry(S), made at its first use.
void need_entry_clock(Machine& machine, NodeId node) {
    for (const auto& clock : machine.clocks)
        if (clock.entry_of == node) return;
    Clock clock;
    clock.name = machine.nodes[node.index].path;
    for (std::size_t at = clock.name.find("::"); at != std::string::npos; at = clock.name.find("::", at))
        clock.name.replace(at, 2, "_");
    clock.entry_of = node;
    clock.origin = machine.nodes[node.index].origin;
    machine.clocks.push_back(std::move(clock));
}

ExprPtr Expressions::clock(const ast::Expr& source) {
    Expr expr;
    expr.span = source.span;
    expr.type = nat_type;
    if (source.kind == ast::ExprKind::since) {
        expr.kind = ExprKind::since;
        expr.clock = look_up(names_.clocks, source.target);
        if (!expr.clock.valid()) lowering_.unresolved("clock '" + source.name.text() + "'", source.span);
        return share(std::move(expr));
    }
    expr.kind = ExprKind::since_entry;
    expr.node = look_up(names_.nodes, source.target);
    if (expr.node.valid() && names_.machine != nullptr)
        need_entry_clock(*names_.machine, expr.node);
    else
        lowering_.unresolved("state '" + source.name.text() + "'", source.span);
    return share(std::move(expr));
}

ExprPtr Expressions::lower_form(const ast::Expr& source, TypeId expected) {
    switch (source.kind) {
        case ast::ExprKind::integer:
        case ast::ExprKind::real:
            return number(source, "");
        case ast::ExprKind::boolean:
            return make_boolean(source.text == "true", source.span);
        case ast::ExprKind::name:
            return name(source, expected);
        case ast::ExprKind::result:
            return refuse(source, "result outside a postcondition");
        case ast::ExprKind::unary:
            return unary(source);
        case ast::ExprKind::binary:
            return binary(source, expected);
        case ast::ExprKind::if_then_else:
            return conditional(source, expected);
        case ast::ExprKind::let:
            return let(source, expected);
        case ast::ExprKind::forall:
        case ast::ExprKind::exists:
        case ast::ExprKind::exists_unique:
        case ast::ExprKind::lambda:
        case ast::ExprKind::the:
        case ast::ExprKind::set_comprehension:
            return binder(source);
        case ast::ExprKind::cast:
            return cast(source);
        case ast::ExprKind::member:
            return member(source);
        case ast::ExprKind::index:
            return index(source);
        case ast::ExprKind::call:
            return call(source);
        case ast::ExprKind::tuple:
            return with_operands(source, ExprKind::tuple);
        case ast::ExprKind::record:
            return record(source);
        case ast::ExprKind::sequence:
            return with_operands(source, ExprKind::sequence);
        case ast::ExprKind::set:
            return with_operands(source, ExprKind::set);
        case ast::ExprKind::set_range:
            return with_operands(source, ExprKind::set_range);
        case ast::ExprKind::matrix:
            return matrix(source);
        case ast::ExprKind::since:
        case ast::ExprKind::since_entry:
            return clock(source);
        case ast::ExprKind::parenthesised:
            return operand(source, 0, expected);
        case ast::ExprKind::string:
            return refuse(source, "a string");
        case ast::ExprKind::to:
        case ast::ExprKind::from:
            return refuse(source, "a broadcast's sender or receiver");
        case ast::ExprKind::is_type:
            return refuse(source, "a type test");
        case ast::ExprKind::range:
            return refuse(source, "a range outside wait([m, n])");
        case ast::ExprKind::inverse:
            return refuse(source, "inverse(..)");
        case ast::ExprKind::transpose:
            return refuse(source, "transpose(..)");
        case ast::ExprKind::error:
            break;
    }
    lowering_.unresolved("an expression", source.span);
    return make_boolean(true, source.span);
}

ExprPtr Expressions::lower(const ast::Expr& source, TypeId expected) {
    return coerce(lowering_, lower_form(source, expected), expected);
}

}  // namespace

ExprPtr lower_expression(Lowering& lowering, const Names& names, const frontend::Expr& source, TypeId expected) {
    return Expressions(lowering, names).lower(source, expected);
}

}  // namespace robochart::ir
