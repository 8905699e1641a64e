// SPDX-License-Identifier: Apache-2.0
// Translates each ExprKind. The switch has no default case, so that the compiler finds a missing kind.
#include "csp_emit/expressions/expressions.hpp"

#include <algorithm>
#include <stdexcept>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/names.hpp"
#include "csp_emit/base/types.hpp"
#include "csp_emit/expressions/clipping.hpp"
#include "csp_emit/expressions/translator.hpp"
#include "semantics/evaluate/evaluate.hpp"
#include "semantics/evaluate/toolkit.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;
using ir::ExprKind;
using ir::TypeKind;
using Op = cspm::ExprKind;

bool Translator::is_whole(ir::TypeId id) const {
    const ir::Type* found = find_type(id);
    return found != nullptr && (found->kind == TypeKind::nat || found->kind == TypeKind::integer);
}

b::Exprs Translator::translate_operands(const ir::Expr& expr) const {
    b::Exprs result;
    for (const auto& part : expr.args) result.push_back(translate(*part));
    return result;
}

ExprPtr Translator::report_unsupported(const std::string& what, const ir::Expr& expr) const {
    project_.report_unsupported(what, expr.span);
    return b::number(0);
}

/// Returns a decimal in units of 1/scale. The scale is chosen from the model's literals, so no literal is rounded.
ExprPtr Translator::real_literal(const ir::Expr& expr) const {
    const auto units = ir::scale_decimal(expr.decimal, scale());
    return units ? b::number(*units) : report_unsupported("a real literal beyond 64 bits", expr);
}

ExprPtr Translator::enum_literal(const ir::Expr& expr) const {
    b::Exprs parts{b::name(literal_name(project_.system.type(expr.type), static_cast<std::size_t>(expr.number)))};
    for (auto& value : translate_operands(expr)) parts.push_back(value);
    return b::dot(parts);
}

ExprPtr Translator::trigger_value(const ir::Expr& expr) const {
    return scope_.trigger_value ? scope_.trigger_value
                                : report_unsupported("a trigger's value outside its transition", expr);
}

ExprPtr Translator::as_type(const ir::Expr& expr, ir::TypeId type) const {
    ExprPtr value = translate(expr);
    const bool timed = expr.kind == ExprKind::since || expr.kind == ExprKind::since_entry;
    if (scale() == 1 || !is_real(type) || !(timed || is_whole(expr.type))) return value;
    if (value->kind == Op::integer) return b::number(value->number * scale());
    return b::binary(Op::times, value, b::number(scale()));
}

/// Compares both operands in the same unit: if one operand is a real, the other is converted to a real.
ExprPtr Translator::translate_comparison(const ir::Expr& expr, cspm::ExprKind op) const {
    const ir::Expr& left = *expr.args.at(0);
    const ir::Expr& right = *expr.args.at(1);
    const ir::TypeId common = is_real(left.type) ? left.type : right.type;
    return b::binary(op, as_type(left, common), as_type(right, common));
}

namespace {

struct Clipping {
    ExprKind kind;
    const char* whole;
    const char* real;  ///< the function for reals with a scale
};

constexpr Clipping clippings[] = {{ExprKind::plus, "Plus", "Plus"},          {ExprKind::minus, "Minus", "Minus"},
                                  {ExprKind::times, "Mult", "RealMult"},     {ExprKind::divide, "Div", "RealDiv"},
                                  {ExprKind::modulus, "Modulus", "Modulus"}, {ExprKind::negate, "Neg", "Neg"}};

/// The operation without clipping. A real r is the number r * scale, so products are divided by the scale, and
/// dividends are multiplied by it, as in the functions that clip (compose/instantiations.cpp).
ExprPtr unclipped_operation(ExprKind kind, const b::Exprs& operands, std::int64_t scale) {
    if (kind == ExprKind::negate) return b::negate(operands.at(0));
    const ExprPtr& left = operands.at(0);
    const ExprPtr& right = operands.at(1);
    if (kind == ExprKind::plus) return b::binary(Op::plus, left, right);
    if (kind == ExprKind::minus) return b::binary(Op::minus, left, right);
    if (kind == ExprKind::modulus) return b::binary(Op::modulus, left, right);
    if (kind == ExprKind::times) {
        const ExprPtr product = b::binary(Op::times, left, right);
        return scale == 1 ? product : b::binary(Op::divide, product, b::number(scale));
    }
    return b::binary(Op::divide, scale == 1 ? left : b::binary(Op::times, left, b::number(scale)), right);
}

const char* clipping_function(ExprKind kind, bool scaled_real) {
    for (const Clipping& clipping : clippings)
        if (clipping.kind == kind) return scaled_real ? clipping.real : clipping.whole;
    throw std::logic_error("an operation on numbers without a function that clips its result");
}

}  // namespace

ExprPtr Translator::clipped_operation(ExprKind kind, b::Exprs operands, ir::TypeId type) const {
    // -3 is a literal and not an operation, because RoboTool's carriers contain every literal of the model with its
    // sign.
    if (kind == ExprKind::negate && operands.at(0)->kind == Op::integer) return b::number(-operands[0]->number);
    const bool scaled = is_real(type) && scale() != 1;
    if (project_.instantiation.unbounded) return unclipped_operation(kind, operands, scaled ? scale() : 1);
    operands.push_back(type_set(project_, type));
    return b::call(clipping_function(kind, scaled), operands);
}

ExprPtr Translator::translate_arithmetic(const ir::Expr& expr) const {
    const ir::Type* result = find_type(expr.type);
    const auto block = [&](const auto& part) { return is_block(part->type); };
    if (std::ranges::any_of(expr.args, block)) return block_arithmetic(expr);
    if (result == nullptr || !is_numeric(*result))
        return report_unsupported("arithmetic on a type that is not a number", expr);
    b::Exprs operands;
    for (const auto& part : expr.args) operands.push_back(as_type(*part, expr.type));
    // RoboTool's clock bounds divide by 1 in the place of 0. The guard itself does not.
    const bool divides = expr.kind == ExprKind::divide || expr.kind == ExprKind::modulus;
    if (divides && !scope_.placed && operands[1]->kind != Op::integer)
        operands[1] = b::call("no_zero_div", {operands[1]});
    return clipped_operation(expr.kind, operands, expr.type);
}

ExprPtr Translator::translate_member(const ir::Expr& expr) const {
    const ir::Type* whole = find_type(expr.args.at(0)->type);
    if (whole == nullptr) return report_unsupported("a component of a value without a type", expr);
    const std::int64_t place = whole->kind == TypeKind::record ? expr.number : expr.number - 1;
    return tuple_part(translate_operand(expr, 0), whole->args.size(), static_cast<std::size_t>(place));
}

ExprPtr Translator::translate_index(const ir::Expr& expr) const {
    b::Exprs places = translate_operands(expr);
    const ExprPtr whole = places.at(0);
    places.erase(places.begin());
    return index_value(expr.args.at(0)->type, whole, places);
}

ExprPtr Translator::translate_cast(const ir::Expr& expr) const {
    const ir::Expr& inner = *expr.args.at(0);
    return convert_value(translate(inner), inner.type, expr.type);
}

/// Translates a type test to `member(v,T)`. A real must also be a whole number.
ExprPtr Translator::type_test(const ir::Expr& expr) const {
    const ir::TypeId tested = expr.bound_types.at(0);
    const ir::TypeId own = expr.args.at(0)->type;
    const ExprPtr value = translate_operand(expr, 0);
    if (!is_real(own) || !is_whole(tested) || scale() == 1)
        return b::call("member", {convert_value(value, own, tested), type_set(project_, tested)});
    const ExprPtr units = b::name("elem__");
    const ExprPtr rest = b::binary(Op::modulus, units, b::number(scale()));
    const ExprPtr number = b::binary(Op::divide, units, b::number(scale()));
    return b::apply(
        b::lambda({b::variable("elem__")}, b::binary(Op::logical_and, b::binary(Op::equal, rest, b::number(0)),
                                                     b::call("member", {number, type_set(project_, tested)}))),
        {value});
}

/// Returns `{low..high}` for whole numbers. For reals, returns the values of the type within the bounds.
ExprPtr Translator::translate_range(const ir::Expr& expr) const {
    const bool open_low = expr.number == 1 || expr.number == 3;
    const bool open_high = expr.number >= 2;
    const ir::Type* set = find_type(expr.type);
    const ir::TypeId element = set != nullptr && !set->args.empty() ? set->args[0] : expr.args.at(0)->type;
    const ExprPtr low = as_type(*expr.args.at(0), element);
    const ExprPtr high = as_type(*expr.args.at(1), element);
    if (!is_real(element))
        return b::set_range(open_low ? b::binary(Op::plus, low, b::number(1)) : low,
                            open_high ? b::binary(Op::minus, high, b::number(1)) : high);
    const ExprPtr elem = b::name("elem__");
    return b::set_comprehension({elem}, {b::generator("elem__", type_set(project_, element)),
                                         b::condition(b::binary(open_low ? Op::less : Op::less_equal, low, elem)),
                                         b::condition(b::binary(open_high ? Op::less : Op::less_equal, elem, high))});
}

/// Translates a call. A function is applied even if it has no arguments, because RoboTool's instantiations define `f()
/// = 0`.
ExprPtr Translator::translate_call(const ir::Expr& expr) const {
    return b::apply(b::name(function_name(project_.system.functions.at(expr.function.index))), call_arguments(expr));
}

b::Exprs Translator::call_arguments(const ir::Expr& expr) const {
    const ir::Function& function = project_.system.functions.at(expr.function.index);
    b::Exprs arguments;
    for (std::size_t i = 0; i < expr.args.size(); ++i)
        arguments.push_back(i < function.parameters.size() ? as_type(*expr.args[i], function.parameters[i])
                                                           : translate_operand(expr, i));
    return arguments;
}

bool Translator::is_open(ir::TypeId id) const {
    const ir::Type* found = find_type(id);
    if (found == nullptr || found->kind == TypeKind::unit) return true;
    return found->kind != TypeKind::record &&
           std::ranges::any_of(found->args, [&](ir::TypeId arg) { return is_open(arg); });
}

ExprPtr Translator::translate_toolkit_call(const ir::Expr& expr) const {
    b::Exprs arguments = translate_operands(expr);
    for (const std::size_t place : ir::toolkit_carriers(expr.text)) {
        if (is_open(expr.bound_types.at(place)))
            return report_unsupported("function " + expr.text + " of elements whose type nothing tells", expr);
        arguments.push_back(type_set(project_, expr.bound_types[place]));
    }
    return b::apply(b::name(expr.text), arguments);
}

ExprPtr Translator::translate_application(const ir::Expr& expr) const {
    b::Exprs arguments = translate_operands(expr);
    const ExprPtr function = arguments.at(0);
    arguments.erase(arguments.begin());
    return b::call("callFunc", {function, tuple_or_one(arguments)});
}

/// Returns `{(x,f(x)) | x <- T}`, restricted to the x that satisfy the precondition.
ExprPtr Translator::function_value(const ir::Expr& expr) const {
    const ir::Function& function = project_.system.functions.at(expr.function.index);
    std::vector<cspm::Clause> clauses;
    b::Exprs arguments;
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const std::string name = "part" + std::to_string(i + 1) + "__";
        clauses.push_back(b::generator(name, type_set(project_, function.parameters[i])));
        arguments.push_back(b::name(name));
    }
    if (arguments.empty()) return report_unsupported("a function without parameters as a value", expr);
    if (!function.preconditions.empty())
        clauses.push_back(b::condition(b::apply(b::name("pre_" + function_name(function)), arguments)));
    const ExprPtr value = b::apply(b::name(function_name(function)), arguments);
    return b::set_comprehension({b::tuple({tuple_or_one(arguments), value})}, clauses);
}

std::vector<cspm::Clause> Translator::make_generators(const ir::Expr& expr) const {
    std::vector<cspm::Clause> clauses;
    for (std::size_t i = 0; i < expr.bound_names.size(); ++i)
        clauses.push_back(b::generator(bound_name(expr.bound_names[i]), type_set(project_, expr.bound_types.at(i))));
    return clauses;
}

ExprPtr Translator::bound_tuple(const ir::Expr& expr) {
    b::Exprs bound;
    for (const std::string& name : expr.bound_names) bound.push_back(b::name(bound_name(name)));
    return tuple_or_one(bound);
}

/// Returns the generators of the bound variables, and the predicate.
std::vector<cspm::Clause> Translator::satisfying_clauses(const ir::Expr& expr) const {
    std::vector<cspm::Clause> clauses = make_generators(expr);
    if (expr.args.at(0)) clauses.push_back(b::condition(translate_operand(expr, 0)));
    return clauses;
}

/// Returns the bound values that satisfy the predicate and the body or, if `negated` is true, the predicate but not the
/// body.
ExprPtr Translator::witness_set(const ir::Expr& expr, bool negated) const {
    std::vector<cspm::Clause> clauses = satisfying_clauses(expr);
    const ExprPtr body = translate_operand(expr, 1);
    clauses.push_back(b::condition(negated ? b::logical_not(body) : body));
    return b::set_comprehension({bound_tuple(expr)}, clauses);
}

/// Returns the values of the body, or the bound values if there is no body.
ExprPtr Translator::translate_comprehension(const ir::Expr& expr) const {
    const std::vector<cspm::Clause> clauses = satisfying_clauses(expr);
    return b::set_comprehension({expr.args.size() > 1 ? translate_operand(expr, 1) : bound_tuple(expr)}, clauses);
}

ExprPtr Translator::translate_lambda(const ir::Expr& expr) const {
    const std::vector<cspm::Clause> clauses = satisfying_clauses(expr);
    return b::set_comprehension({b::tuple({bound_tuple(expr), translate_operand(expr, 1)})}, clauses);
}

/// Wraps the first `count` bindings around a body. In CSPM a `let` is recursive, but in RoboChart the value of a
/// binding can use only the bindings before it.
ExprPtr Translator::bind_let(const ir::Expr& expr, std::size_t count, ExprPtr body) const {
    for (std::size_t i = count; i-- > 0;)
        body =
            b::apply(b::lambda({b::variable(bound_name(expr.bound_names.at(i)))}, body), {translate_operand(expr, i)});
    return body;
}

ExprPtr Translator::translate_let(const ir::Expr& expr) const {
    return bind_let(expr, expr.bound_names.size(), translate(*expr.args.back()));
}

ExprPtr Translator::translate(const ir::Expr& expr) const {
    project_.diagnostics.poll();
    switch (expr.kind) {
        case ExprKind::boolean:
            return b::boolean(expr.number != 0);
        case ExprKind::integer:
            return b::number(is_real(expr.type) ? expr.number * scale() : expr.number);
        case ExprKind::real:
            return real_literal(expr);
        case ExprKind::string:
            return b::string(expr.characters.unescaped());
        case ExprKind::enum_literal:
            return enum_literal(expr);
        case ExprKind::variable:
            return scope_.variable(expr.variable);
        case ExprKind::trigger_value:
            return trigger_value(expr);
        case ExprKind::constant:
            return scope_.constant(expr.constant);
        case ExprKind::since:
            return scope_.clock(expr.clock);
        case ExprKind::since_entry:
            return scope_.entry_clock(expr.node);
        case ExprKind::bound:
            return b::name(bound_name(expr.text));
        case ExprKind::logical_not:
            return b::logical_not(translate_operand(expr, 0));
        case ExprKind::iff:
            return b::binary(Op::equal, translate_operand(expr, 0), translate_operand(expr, 1));
        case ExprKind::implies:
            return b::binary(Op::logical_or, b::logical_not(translate_operand(expr, 0)), translate_operand(expr, 1));
        case ExprKind::disjunction:
            return b::binary(Op::logical_or, translate_operand(expr, 0), translate_operand(expr, 1));
        case ExprKind::conjunction:
            return b::binary(Op::logical_and, translate_operand(expr, 0), translate_operand(expr, 1));
        case ExprKind::equal:
            return translate_comparison(expr, Op::equal);
        case ExprKind::not_equal:
            return translate_comparison(expr, Op::not_equal);
        case ExprKind::greater:
            return translate_comparison(expr, Op::greater);
        case ExprKind::greater_equal:
            return translate_comparison(expr, Op::greater_equal);
        case ExprKind::less:
            return translate_comparison(expr, Op::less);
        case ExprKind::less_equal:
            return translate_comparison(expr, Op::less_equal);
        case ExprKind::negate:
        case ExprKind::plus:
        case ExprKind::minus:
        case ExprKind::times:
        case ExprKind::divide:
        case ExprKind::modulus:
            return translate_arithmetic(expr);
        case ExprKind::if_then_else:
            return b::if_(translate_operand(expr, 0), as_type(*expr.args.at(1), expr.type),
                          as_type(*expr.args.at(2), expr.type));
        case ExprKind::call:
            return translate_call(expr);
        case ExprKind::tuple:
        case ExprKind::record:
            return tuple_or_one(translate_operands(expr));
        case ExprKind::sequence:
            return b::sequence(translate_operands(expr));
        case ExprKind::set:
            return b::set(translate_operands(expr));
        case ExprKind::set_range:
            return b::set_range(translate_operand(expr, 0), translate_operand(expr, 1));
        case ExprKind::concat:
            return b::binary(Op::concat, translate_operand(expr, 0), translate_operand(expr, 1));
        case ExprKind::is_in:
            return b::call("member", translate_operands(expr));
        case ExprKind::matrix:
            return block_literal(expr);
        case ExprKind::transpose:
            return transpose_block(expr);
        case ExprKind::index:
            return translate_index(expr);
        case ExprKind::range:
            return translate_range(expr);
        case ExprKind::is_type:
            return type_test(expr);
        case ExprKind::toolkit:
            return translate_toolkit_call(expr);
        case ExprKind::apply:
            return translate_application(expr);
        case ExprKind::function_value:
            return function_value(expr);
        case ExprKind::member:
            return translate_member(expr);
        case ExprKind::cast:
            return translate_cast(expr);
        case ExprKind::let:
            return translate_let(expr);
        case ExprKind::forall:
            return b::call("empty", {witness_set(expr, true)});
        case ExprKind::exists:
            return b::logical_not(b::call("empty", {witness_set(expr, false)}));
        case ExprKind::exists_unique:
            return b::binary(Op::equal, b::call("card", {witness_set(expr, false)}), b::number(1));
        case ExprKind::lambda:
            return translate_lambda(expr);
        case ExprKind::the:
            return b::call("theOnly__", {translate_comprehension(expr)});
        case ExprKind::set_comprehension:
            return translate_comprehension(expr);
    }
    return report_unsupported("this kind of expression", expr);
}

std::string function_name(const ir::Function& function) {
    return function.package.empty() ? function.name : flatten_name(function.package) + "_" + function.name;
}

ExprPtr translate_expression(const Project& project, const Scope& scope, const ir::Expr& expr) {
    const ExprPtr result = Translator(project, scope).translate(expr);
    return scope.placed ? with_place(result, expr.span) : result;
}

ExprPtr expression_as(const Project& project, const Scope& scope, const ir::Expr& expr, ir::TypeId type) {
    const ExprPtr result = Translator(project, scope).as_type(expr, type);
    return scope.placed ? with_place(result, expr.span) : result;
}

ExprPtr received_as(const Project& project, const ExprPtr& value, ir::TypeId event, ir::TypeId variable,
                    diagnostics::Span reception) {
    const Scope nothing;
    const Translator translator(project, nothing);
    if (translator.narrows_numbers(event, variable))
        project.report_unsupported("receiving a real into a whole number", reception);
    return translator.convert_value(value, event, variable);
}

std::vector<ExprPtr> translate_preconditions(const Project& project, const Scope& scope, const ir::Expr& expr) {
    std::vector<ExprPtr> result = Translator(project, scope).preconditions(expr);
    if (scope.placed)
        for (ExprPtr& condition : result) condition = with_place(condition, expr.span);
    return result;
}

ExprPtr replace_component(const Project& project, ir::TypeId type, const ExprPtr& whole,
                          const std::vector<ExprPtr>& path, const ExprPtr& value) {
    return Translator(project, {}).replace_part(type, whole, path, 0, value);
}

void walk_parts(const ir::Expr& expr, const std::function<void(const ir::Expr&)>& visit) {
    visit(expr);
    for (const auto& part : expr.args)
        if (part) walk_parts(*part, visit);
}

bool has_part(const ir::Expr& expr, const std::function<bool(const ir::Expr&)>& predicate) {
    bool found = false;
    walk_parts(expr, [&](const ir::Expr& part) { found = found || predicate(part); });
    return found;
}

}  // namespace robochart::csp_emit
