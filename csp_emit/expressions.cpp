// One function per family of ExprKind.
#include "csp_emit/expressions.hpp"

#include "checker/cspm/build.hpp"
#include "csp_emit/bounds.hpp"
#include "csp_emit/names.hpp"
#include "csp_emit/types.hpp"
#include "semantics/evaluate.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;
using ir::ExprKind;
using ir::TypeKind;
using Op = cspm::ExprKind;

namespace {

class Translator {
public:
    Translator(const Project& project, const Scope& scope) : project_(project), scope_(scope) {}

    ExprPtr translate(const ir::Expr& expr) const;
    ExprPtr as_type(const ir::Expr& expr, ir::TypeId wanted) const;

private:
    const ir::Type* type(ir::TypeId id) const { return id.valid() ? &project_.system.type(id) : nullptr; }
    bool is_real(ir::TypeId id) const { return id.valid() && project_.system.type(id).kind == TypeKind::real; }
    bool is_whole(ir::TypeId id) const;
    std::int64_t scale() const { return project_.instantiation.scale; }

    ExprPtr arg(const ir::Expr& expr, std::size_t index) const { return translate(*expr.args.at(index)); }
    b::Exprs args(const ir::Expr& expr) const;
    ExprPtr literal(const ir::Expr& expr) const;
    ExprPtr real_literal(const ir::Expr& expr) const;
    ExprPtr name(const ir::Expr& expr) const;
    ExprPtr logic(const ir::Expr& expr) const;
    ExprPtr comparison(const ir::Expr& expr) const;
    ExprPtr arithmetic(const ir::Expr& expr) const;
    ExprPtr composed(const ir::Expr& expr) const;
    ExprPtr member(const ir::Expr& expr) const;
    ExprPtr cast(const ir::Expr& expr) const;
    ExprPtr call(const ir::Expr& expr) const;
    ExprPtr quantified(const ir::Expr& expr) const;
    ExprPtr let(const ir::Expr& expr) const;
    ExprPtr refused(const std::string& what, const ir::Expr& expr) const;

    const Project& project_;
    const Scope& scope_;
};

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

/// A decimal in units of 1/scale. The scale is chosen from the model's literals, so nothing is rounded off there.
ExprPtr Translator::real_literal(const ir::Expr& expr) const {
    const auto units = ir::scaled(expr.decimal, scale());
    return units ? b::number(*units) : refused("a real literal beyond 64 bits", expr);
}

ExprPtr Translator::literal(const ir::Expr& expr) const {
    switch (expr.kind) {
        case ExprKind::boolean:
            return b::boolean(expr.number != 0);
        case ExprKind::real:
            return real_literal(expr);
        case ExprKind::string:
            return b::string(expr.text);
        case ExprKind::enum_literal: {
            b::Exprs parts{
                b::name(literal_name(project_.system.type(expr.type), static_cast<std::size_t>(expr.number)))};
            for (auto& value : args(expr)) parts.push_back(value);
            return b::dot(parts);
        }
        default:
            return is_real(expr.type) ? b::number(expr.number * scale()) : b::number(expr.number);
    }
}

ExprPtr Translator::name(const ir::Expr& expr) const {
    switch (expr.kind) {
        case ExprKind::variable:
            return scope_.variable(expr.variable);
        case ExprKind::constant:
            return scope_.constant(expr.constant);
        case ExprKind::since:
            return scope_.clock(expr.clock);
        case ExprKind::since_entry:
            return scope_.entry_clock(expr.node);
        case ExprKind::trigger_value:
            return scope_.trigger_value ? scope_.trigger_value
                                        : refused("a trigger's value outside its transition", expr);
        default:
            return b::name(expr.text + "__q");  // bound variables cannot clash: no element ends so
    }
}

ExprPtr Translator::as_type(const ir::Expr& expr, ir::TypeId wanted) const {
    ExprPtr value = translate(expr);
    const bool timed = expr.kind == ExprKind::since || expr.kind == ExprKind::since_entry;
    if (scale() == 1 || !is_real(wanted) || !(timed || is_whole(expr.type))) return value;
    if (value->kind == Op::integer) return b::number(value->number * scale());
    return b::binary(Op::times, value, b::number(scale()));
}

ExprPtr Translator::logic(const ir::Expr& expr) const {
    switch (expr.kind) {
        case ExprKind::logical_not:
            return b::logical_not(arg(expr, 0));
        case ExprKind::iff:
            return b::binary(Op::equal, arg(expr, 0), arg(expr, 1));
        case ExprKind::implies:
            return b::binary(Op::logical_or, b::logical_not(arg(expr, 0)), arg(expr, 1));
        case ExprKind::disjunction:
            return b::binary(Op::logical_or, arg(expr, 0), arg(expr, 1));
        default:
            return b::binary(Op::logical_and, arg(expr, 0), arg(expr, 1));
    }
}

Op comparison_operator(ExprKind kind) {
    switch (kind) {
        case ExprKind::equal:
            return Op::equal;
        case ExprKind::not_equal:
            return Op::not_equal;
        case ExprKind::greater:
            return Op::greater;
        case ExprKind::greater_equal:
            return Op::greater_equal;
        case ExprKind::less:
            return Op::less;
        default:
            return Op::less_equal;
    }
}

/// Both sides in the same unit: a real on either side makes the other one real.
ExprPtr Translator::comparison(const ir::Expr& expr) const {
    const ir::Expr& left = *expr.args.at(0);
    const ir::Expr& right = *expr.args.at(1);
    const ir::TypeId common = is_real(left.type) ? left.type : right.type;
    return b::binary(comparison_operator(expr.kind), as_type(left, common), as_type(right, common));
}

const char* clipping_function(ExprKind kind, bool scaled_real) {
    switch (kind) {
        case ExprKind::plus:
            return "Plus";
        case ExprKind::minus:
            return "Minus";
        case ExprKind::times:
            return scaled_real ? "RealMult" : "Mult";
        case ExprKind::divide:
            return scaled_real ? "RealDiv" : "Div";
        case ExprKind::negate:
            return "Neg";
        default:
            return "Modulus";
    }
}

ExprPtr Translator::arithmetic(const ir::Expr& expr) const {
    const ir::Type* result = type(expr.type);
    if (result == nullptr || !numeric(*result)) return refused("arithmetic on a type that is not a number", expr);
    b::Exprs operands;
    for (const auto& part : expr.args) operands.push_back(as_type(*part, expr.type));
    // -3 is a literal, not an operation: RoboTool's carriers hold every literal of the model with its sign.
    if (expr.kind == ExprKind::negate && operands.at(0)->kind == Op::integer) return b::number(-operands[0]->number);
    operands.push_back(type_set(project_, expr.type));
    return b::call(clipping_function(expr.kind, is_real(expr.type) && scale() != 1), operands);
}

/// Selects one component of a tuple by a lambda over its pattern.
ExprPtr Translator::member(const ir::Expr& expr) const {
    const ir::Type* whole = type(expr.args.at(0)->type);
    if (whole == nullptr) return refused("a component of a value without a type", expr);
    const bool record = whole->kind == TypeKind::record;
    const std::size_t size = whole->args.size();
    const auto place = static_cast<std::size_t>(record ? expr.number : expr.number - 1);
    if (size == 1) return arg(expr, 0);
    b::Patterns parts;
    for (std::size_t i = 0; i < size; ++i) parts.push_back(i == place ? b::variable("part__") : b::wildcard());
    return b::apply(b::lambda({b::tuple_pattern(parts)}, b::name("part__")), {arg(expr, 0)});
}

ExprPtr Translator::cast(const ir::Expr& expr) const {
    const ir::Expr& inner = *expr.args.at(0);
    if (is_real(expr.type) || !is_real(inner.type) || scale() == 1) return as_type(inner, expr.type);
    return b::binary(Op::divide, translate(inner), b::number(scale()));
}

ExprPtr Translator::composed(const ir::Expr& expr) const {
    const b::Exprs parts = args(expr);
    switch (expr.kind) {
        case ExprKind::sequence:
            return b::sequence(parts);
        case ExprKind::set:
            return b::set(parts);
        case ExprKind::set_range:
            return b::set_range(parts.at(0), parts.at(1));
        case ExprKind::concat:
            return b::binary(Op::concat, parts.at(0), parts.at(1));
        case ExprKind::is_in:
            return b::call("member", parts);
        case ExprKind::index:
            return b::call("access_", parts);
        default:
            return parts.size() == 1 ? parts[0] : b::tuple(parts);
    }
}

ExprPtr Translator::call(const ir::Expr& expr) const {
    const ir::Function& function = project_.system.functions.at(expr.function.index);
    b::Exprs arguments;
    for (std::size_t i = 0; i < expr.args.size(); ++i)
        arguments.push_back(i < function.parameters.size() ? as_type(*expr.args[i], function.parameters[i])
                                                           : arg(expr, i));
    return b::call(function_name(function), arguments);
}

ExprPtr Translator::quantified(const ir::Expr& expr) const {
    std::vector<cspm::Clause> clauses;
    b::Exprs bound;
    for (std::size_t i = 0; i < expr.bound_names.size(); ++i) {
        clauses.push_back(b::generator(expr.bound_names[i] + "__q", type_set(project_, expr.bound_types.at(i))));
        bound.push_back(b::name(expr.bound_names[i] + "__q"));
    }
    const ExprPtr all = bound.size() == 1 ? bound[0] : b::tuple(bound);
    if (expr.args.at(0)) clauses.push_back(b::condition(arg(expr, 0)));
    switch (expr.kind) {
        case ExprKind::forall:
            clauses.push_back(b::condition(b::logical_not(arg(expr, 1))));
            return b::call("empty", {b::set_comprehension({all}, clauses)});
        case ExprKind::exists:
            clauses.push_back(b::condition(arg(expr, 1)));
            return b::logical_not(b::call("empty", {b::set_comprehension({all}, clauses)}));
        case ExprKind::exists_unique:
            clauses.push_back(b::condition(arg(expr, 1)));
            return b::binary(Op::equal, b::call("card", {b::set_comprehension({all}, clauses)}), b::number(1));
        case ExprKind::lambda:
            return b::set_comprehension({b::tuple({all, arg(expr, 1)})}, clauses);
        case ExprKind::set_comprehension:
            return b::set_comprehension({arg(expr, 1)}, clauses);
        default:
            return refused("a definite description (the)", expr);
    }
}

ExprPtr Translator::let(const ir::Expr& expr) const {
    b::Decls decls;
    for (std::size_t i = 0; i < expr.bound_names.size(); ++i)
        decls.push_back(b::value(expr.bound_names[i] + "__q", arg(expr, i)));
    return b::let_(decls, translate(*expr.args.back()));
}

ExprPtr Translator::translate(const ir::Expr& expr) const {
    switch (expr.kind) {
        case ExprKind::boolean:
        case ExprKind::integer:
        case ExprKind::real:
        case ExprKind::string:
        case ExprKind::enum_literal:
            return literal(expr);
        case ExprKind::variable:
        case ExprKind::trigger_value:
        case ExprKind::constant:
        case ExprKind::since:
        case ExprKind::since_entry:
        case ExprKind::bound:
            return name(expr);
        case ExprKind::logical_not:
        case ExprKind::iff:
        case ExprKind::implies:
        case ExprKind::disjunction:
        case ExprKind::conjunction:
            return logic(expr);
        case ExprKind::equal:
        case ExprKind::not_equal:
        case ExprKind::greater:
        case ExprKind::greater_equal:
        case ExprKind::less:
        case ExprKind::less_equal:
            return comparison(expr);
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
        case ExprKind::sequence:
        case ExprKind::set:
        case ExprKind::set_range:
        case ExprKind::concat:
        case ExprKind::is_in:
        case ExprKind::index:
            return composed(expr);
        case ExprKind::member:
            return member(expr);
        case ExprKind::cast:
            return cast(expr);
        case ExprKind::let:
            return let(expr);
        case ExprKind::forall:
        case ExprKind::exists:
        case ExprKind::exists_unique:
        case ExprKind::lambda:
        case ExprKind::the:
        case ExprKind::set_comprehension:
            return quantified(expr);
        default:
            return refused("this kind of expression", expr);
    }
}

}  // namespace

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

std::vector<ExprPtr> preconditions(const Project& project, const Scope& scope, const ir::Expr& expr) {
    std::vector<ExprPtr> result;
    const Translator translator(project, scope);
    walk(expr, [&](const ir::Expr& part) {
        if (part.kind != ExprKind::call) return;
        const ir::Function& function = project.system.functions.at(part.function.index);
        if (function.preconditions.empty()) return;
        b::Exprs arguments;
        for (const auto& argument : part.args) arguments.push_back(translator.translate(*argument));
        result.push_back(b::call("pre_" + function_name(function), arguments));
    });
    return result;
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
