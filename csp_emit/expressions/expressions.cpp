// SPDX-License-Identifier: Apache-2.0
// One case per ExprKind; no default, so that the compiler finds a kind that is missing.
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
    const ir::Type* found = type(id);
    return found != nullptr && (found->kind == TypeKind::nat || found->kind == TypeKind::integer);
}

b::Exprs Translator::args(const ir::Expr& expr) const {
    b::Exprs result;
    for (const auto& part : expr.args) result.push_back(translate(*part));
    return result;
}

ExprPtr Translator::refused(const std::string& what, const ir::Expr& expr) const {
    project_.refuse(what, expr.span);
    return b::number(0);
}

/// A decimal in units of 1/scale. The scale is chosen from the model's literals, so no literal is rounded.
ExprPtr Translator::real_literal(const ir::Expr& expr) const {
    const auto units = ir::scaled(expr.decimal, scale());
    return units ? b::number(*units) : refused("a real literal beyond 64 bits", expr);
}

ExprPtr Translator::enum_literal(const ir::Expr& expr) const {
    b::Exprs parts{b::name(literal_name(project_.system.type(expr.type), static_cast<std::size_t>(expr.number)))};
    for (auto& value : args(expr)) parts.push_back(value);
    return b::dot(parts);
}

ExprPtr Translator::trigger_value(const ir::Expr& expr) const {
    return scope_.trigger_value ? scope_.trigger_value : refused("a trigger's value outside its transition", expr);
}

ExprPtr Translator::as_type(const ir::Expr& expr, ir::TypeId wanted) const {
    ExprPtr value = translate(expr);
    const bool timed = expr.kind == ExprKind::since || expr.kind == ExprKind::since_entry;
    if (scale() == 1 || !is_real(wanted) || !(timed || is_whole(expr.type))) return value;
    if (value->kind == Op::integer) return b::number(value->number * scale());
    return b::binary(Op::times, value, b::number(scale()));
}

/// Compares both operands in the same unit: if one operand is a real, the other is converted to a real.
ExprPtr Translator::comparison(const ir::Expr& expr, cspm::ExprKind op) const {
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

const char* clipping_function(ExprKind kind, bool scaled_real) {
    for (const Clipping& each : clippings)
        if (each.kind == kind) return scaled_real ? each.real : each.whole;
    throw std::logic_error("an operation on numbers without a function that clips its result");
}

}  // namespace

ExprPtr Translator::clipped(ExprKind kind, b::Exprs operands, ir::TypeId type) const {
    // -3 is a literal, not an operation: RoboTool's carriers contain every literal of the model with its sign.
    if (kind == ExprKind::negate && operands.at(0)->kind == Op::integer) return b::number(-operands[0]->number);
    operands.push_back(type_set(project_, type));
    return b::call(clipping_function(kind, is_real(type) && scale() != 1), operands);
}

ExprPtr Translator::arithmetic(const ir::Expr& expr) const {
    const ir::Type* result = type(expr.type);
    const auto block = [&](const auto& part) { return is_block(part->type); };
    if (std::ranges::any_of(expr.args, block)) return block_arithmetic(expr);
    if (result == nullptr || !numeric(*result)) return refused("arithmetic on a type that is not a number", expr);
    b::Exprs operands;
    for (const auto& part : expr.args) operands.push_back(as_type(*part, expr.type));
    // RoboTool's clock bounds divide by 1 if a value of the type is 0; the guard itself does not.
    const bool divides = expr.kind == ExprKind::divide || expr.kind == ExprKind::modulus;
    if (divides && !scope_.placed && operands[1]->kind != Op::integer)
        operands[1] = b::call("no_zero_div", {operands[1]});
    return clipped(expr.kind, operands, expr.type);
}

ExprPtr Translator::member(const ir::Expr& expr) const {
    const ir::Type* whole = type(expr.args.at(0)->type);
    if (whole == nullptr) return refused("a component of a value without a type", expr);
    const std::int64_t place = whole->kind == TypeKind::record ? expr.number : expr.number - 1;
    return tuple_part(arg(expr, 0), whole->args.size(), static_cast<std::size_t>(place));
}

ExprPtr Translator::index(const ir::Expr& expr) const {
    b::Exprs places = args(expr);
    const ExprPtr whole = places.at(0);
    places.erase(places.begin());
    return indexed(expr.args.at(0)->type, whole, places);
}

ExprPtr Translator::cast(const ir::Expr& expr) const {
    const ir::Expr& inner = *expr.args.at(0);
    return converted(translate(inner), inner.type, expr.type);
}

/// `member(v,T)`; a real must also be a whole number.
ExprPtr Translator::type_test(const ir::Expr& expr) const {
    const ir::TypeId wanted = expr.bound_types.at(0);
    const ir::TypeId own = expr.args.at(0)->type;
    const ExprPtr value = arg(expr, 0);
    if (!is_real(own) || !is_whole(wanted) || scale() == 1)
        return b::call("member", {converted(value, own, wanted), type_set(project_, wanted)});
    const ExprPtr units = b::name("elem__");
    const ExprPtr rest = b::binary(Op::modulus, units, b::number(scale()));
    const ExprPtr number = b::binary(Op::divide, units, b::number(scale()));
    return b::apply(
        b::lambda({b::variable("elem__")}, b::binary(Op::logical_and, b::binary(Op::equal, rest, b::number(0)),
                                                     b::call("member", {number, type_set(project_, wanted)}))),
        {value});
}

/// `{low..high}` for whole numbers; for reals, the values of the type within the bounds.
ExprPtr Translator::range(const ir::Expr& expr) const {
    const bool open_low = expr.number == 1 || expr.number == 3;
    const bool open_high = expr.number >= 2;
    const ir::Type* set = type(expr.type);
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

/// A function is applied even if it has no arguments: RoboTool's instantiations define `f() = 0`.
ExprPtr Translator::call(const ir::Expr& expr) const {
    return b::apply(b::name(function_name(project_.system.functions.at(expr.function.index))), call_arguments(expr));
}

b::Exprs Translator::call_arguments(const ir::Expr& expr) const {
    const ir::Function& function = project_.system.functions.at(expr.function.index);
    b::Exprs arguments;
    for (std::size_t i = 0; i < expr.args.size(); ++i)
        arguments.push_back(i < function.parameters.size() ? as_type(*expr.args[i], function.parameters[i])
                                                           : arg(expr, i));
    return arguments;
}

bool Translator::is_open(ir::TypeId id) const {
    const ir::Type* found = type(id);
    if (found == nullptr || found->kind == TypeKind::unit) return true;
    return found->kind != TypeKind::record &&
           std::ranges::any_of(found->args, [&](ir::TypeId arg) { return is_open(arg); });
}

ExprPtr Translator::toolkit(const ir::Expr& expr) const {
    b::Exprs arguments = args(expr);
    for (const std::size_t place : ir::toolkit_carriers(expr.text)) {
        if (is_open(expr.bound_types.at(place)))
            return refused("function " + expr.text + " of elements whose type nothing tells", expr);
        arguments.push_back(type_set(project_, expr.bound_types[place]));
    }
    return b::apply(b::name(expr.text), arguments);
}

ExprPtr Translator::apply(const ir::Expr& expr) const {
    b::Exprs arguments = args(expr);
    const ExprPtr function = arguments.at(0);
    arguments.erase(arguments.begin());
    return b::call("callFunc", {function, tuple_or_one(arguments)});
}

/// `{(x,f(x)) | x <- T}`, restricted to the x that satisfy the precondition.
ExprPtr Translator::function_value(const ir::Expr& expr) const {
    const ir::Function& function = project_.system.functions.at(expr.function.index);
    std::vector<cspm::Clause> clauses;
    b::Exprs arguments;
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const std::string name = "part" + std::to_string(i + 1) + "__";
        clauses.push_back(b::generator(name, type_set(project_, function.parameters[i])));
        arguments.push_back(b::name(name));
    }
    if (arguments.empty()) return refused("a function without parameters as a value", expr);
    if (!function.preconditions.empty())
        clauses.push_back(b::condition(b::apply(b::name("pre_" + function_name(function)), arguments)));
    const ExprPtr value = b::apply(b::name(function_name(function)), arguments);
    return b::set_comprehension({b::tuple({tuple_or_one(arguments), value})}, clauses);
}

std::vector<cspm::Clause> Translator::generators(const ir::Expr& expr) const {
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

/// The generators of the bound variables, and the predicate.
std::vector<cspm::Clause> Translator::satisfying(const ir::Expr& expr) const {
    std::vector<cspm::Clause> clauses = generators(expr);
    if (expr.args.at(0)) clauses.push_back(b::condition(arg(expr, 0)));
    return clauses;
}

/// The bound values that satisfy the predicate and the body; with `negated`, the predicate and not the body.
ExprPtr Translator::witnesses(const ir::Expr& expr, bool negated) const {
    std::vector<cspm::Clause> clauses = satisfying(expr);
    const ExprPtr body = arg(expr, 1);
    clauses.push_back(b::condition(negated ? b::logical_not(body) : body));
    return b::set_comprehension({bound_tuple(expr)}, clauses);
}

/// The values of the body, or the bound values if there is no body.
ExprPtr Translator::comprehension(const ir::Expr& expr) const {
    const std::vector<cspm::Clause> clauses = satisfying(expr);
    return b::set_comprehension({expr.args.size() > 1 ? arg(expr, 1) : bound_tuple(expr)}, clauses);
}

ExprPtr Translator::lambda(const ir::Expr& expr) const {
    const std::vector<cspm::Clause> clauses = satisfying(expr);
    return b::set_comprehension({b::tuple({bound_tuple(expr), arg(expr, 1)})}, clauses);
}

/// Wraps the first `count` bindings around a body. CSPM's own `let` is recursive; here each value sees only the
/// bindings before it.
ExprPtr Translator::bind_let(const ir::Expr& expr, std::size_t count, ExprPtr body) const {
    for (std::size_t i = count; i-- > 0;)
        body = b::apply(b::lambda({b::variable(bound_name(expr.bound_names.at(i)))}, body), {arg(expr, i)});
    return body;
}

ExprPtr Translator::let(const ir::Expr& expr) const {
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
            return b::logical_not(arg(expr, 0));
        case ExprKind::iff:
            return b::binary(Op::equal, arg(expr, 0), arg(expr, 1));
        case ExprKind::implies:
            return b::binary(Op::logical_or, b::logical_not(arg(expr, 0)), arg(expr, 1));
        case ExprKind::disjunction:
            return b::binary(Op::logical_or, arg(expr, 0), arg(expr, 1));
        case ExprKind::conjunction:
            return b::binary(Op::logical_and, arg(expr, 0), arg(expr, 1));
        case ExprKind::equal:
            return comparison(expr, Op::equal);
        case ExprKind::not_equal:
            return comparison(expr, Op::not_equal);
        case ExprKind::greater:
            return comparison(expr, Op::greater);
        case ExprKind::greater_equal:
            return comparison(expr, Op::greater_equal);
        case ExprKind::less:
            return comparison(expr, Op::less);
        case ExprKind::less_equal:
            return comparison(expr, Op::less_equal);
        case ExprKind::negate:
        case ExprKind::plus:
        case ExprKind::minus:
        case ExprKind::times:
        case ExprKind::divide:
        case ExprKind::modulus:
            return arithmetic(expr);
        case ExprKind::if_then_else:
            return b::if_(arg(expr, 0), as_type(*expr.args.at(1), expr.type), as_type(*expr.args.at(2), expr.type));
        case ExprKind::call:
            return call(expr);
        case ExprKind::tuple:
        case ExprKind::record:
            return tuple_or_one(args(expr));
        case ExprKind::sequence:
            return b::sequence(args(expr));
        case ExprKind::set:
            return b::set(args(expr));
        case ExprKind::set_range:
            return b::set_range(arg(expr, 0), arg(expr, 1));
        case ExprKind::concat:
            return b::binary(Op::concat, arg(expr, 0), arg(expr, 1));
        case ExprKind::is_in:
            return b::call("member", args(expr));
        case ExprKind::matrix:
            return block_literal(expr);
        case ExprKind::transpose:
            return transposed(expr);
        case ExprKind::index:
            return index(expr);
        case ExprKind::range:
            return range(expr);
        case ExprKind::is_type:
            return type_test(expr);
        case ExprKind::toolkit:
            return toolkit(expr);
        case ExprKind::apply:
            return apply(expr);
        case ExprKind::function_value:
            return function_value(expr);
        case ExprKind::member:
            return member(expr);
        case ExprKind::cast:
            return cast(expr);
        case ExprKind::let:
            return let(expr);
        case ExprKind::forall:
            return b::call("empty", {witnesses(expr, true)});
        case ExprKind::exists:
            return b::logical_not(b::call("empty", {witnesses(expr, false)}));
        case ExprKind::exists_unique:
            return b::binary(Op::equal, b::call("card", {witnesses(expr, false)}), b::number(1));
        case ExprKind::lambda:
            return lambda(expr);
        case ExprKind::the:
            return b::call("theOnly__", {comprehension(expr)});
        case ExprKind::set_comprehension:
            return comprehension(expr);
    }
    return refused("this kind of expression", expr);
}

std::string function_name(const ir::Function& function) {
    return function.package.empty() ? function.name : flatten(function.package) + "_" + function.name;
}

ExprPtr expression(const Project& project, const Scope& scope, const ir::Expr& expr) {
    const ExprPtr result = Translator(project, scope).translate(expr);
    return scope.placed ? placed(result, expr.span) : result;
}

ExprPtr expression_as(const Project& project, const Scope& scope, const ir::Expr& expr, ir::TypeId wanted) {
    const ExprPtr result = Translator(project, scope).as_type(expr, wanted);
    return scope.placed ? placed(result, expr.span) : result;
}

ExprPtr received_as(const Project& project, const ExprPtr& value, ir::TypeId event, ir::TypeId variable,
                    diagnostics::Span reception) {
    const Scope nothing;
    const Translator translator(project, nothing);
    if (translator.narrows(event, variable)) project.refuse("receiving a real into a whole number", reception);
    return translator.converted(value, event, variable);
}

std::vector<ExprPtr> preconditions(const Project& project, const Scope& scope, const ir::Expr& expr) {
    std::vector<ExprPtr> result = Translator(project, scope).preconditions(expr);
    if (scope.placed)
        for (ExprPtr& condition : result) condition = placed(condition, expr.span);
    return result;
}

ExprPtr component(const Project& project, ir::TypeId type, const ExprPtr& whole, const std::vector<ExprPtr>& path,
                  const ExprPtr& value) {
    return Translator(project, {}).replaced(type, whole, path, 0, value);
}

void walk(const ir::Expr& expr, const std::function<void(const ir::Expr&)>& visit) {
    visit(expr);
    for (const auto& part : expr.args)
        if (part) walk(*part, visit);
}

bool mentions(const ir::Expr& expr, const std::function<bool(const ir::Expr&)>& predicate) {
    bool found = false;
    walk(expr, [&](const ir::Expr& part) { found = found || predicate(part); });
    return found;
}

}  // namespace robochart::csp_emit
