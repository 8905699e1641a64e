// SPDX-License-Identifier: Apache-2.0
#include "prism/emit/expressions.hpp"

#include <algorithm>
#include <utility>

#include "prism/emit/rules.hpp"
#include "prism/emit/tree.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::prism_emit {
namespace {

using ir::ExprKind;
using prism::ExprPtr;
using prism::Op;

/// Returns the operator of PRISM if it has the same meaning in both languages.
std::optional<Op> operator_of(ExprKind kind) {
    switch (kind) {
        case ExprKind::negate:
            return Op::minus;
        case ExprKind::logical_not:
            return Op::negation;
        case ExprKind::iff:
            return Op::iff;
        case ExprKind::implies:
            return Op::implies;
        case ExprKind::disjunction:
            return Op::disjunction;
        case ExprKind::conjunction:
            return Op::conjunction;
        case ExprKind::equal:
            return Op::equal;
        case ExprKind::not_equal:
            return Op::unequal;
        case ExprKind::greater:
            return Op::greater;
        case ExprKind::greater_equal:
            return Op::greater_equal;
        case ExprKind::less:
            return Op::less;
        case ExprKind::less_equal:
            return Op::less_equal;
        case ExprKind::plus:
            return Op::add;
        case ExprKind::minus:
            return Op::subtract;
        case ExprKind::times:
            return Op::multiply;
        case ExprKind::if_then_else:
            return Op::conditional;
        default:
            return std::nullopt;
    }
}

/// Returns an exact decimal in PRISM's notation.
ExprPtr decimal_literal(const ir::Decimal& value) {
    if (value.decimals == 0) return tree::number(value.unscaled);
    std::string digits = std::to_string(value.unscaled);
    const bool negative = digits.front() == '-';
    if (negative) digits.erase(0, 1);
    if (digits.size() <= value.decimals) digits.insert(0, value.decimals + 1 - digits.size(), '0');
    digits.insert(digits.size() - value.decimals, ".");
    const ExprPtr real = prism::make_expr(Op::real, {}, {}, digits);
    return negative ? tree::apply(Op::minus, {real}) : real;
}

class Translator {
public:
    Translator(Context& context, const Scope& scope) : context_(context), scope_(scope) {}

    ExprPtr operator()(const ir::Expr& expr) {
        context_.diagnostics.poll();
        if (const auto op = operator_of(expr.kind)) return tree::apply(*op, translate_operands(expr));
        switch (expr.kind) {
            case ExprKind::boolean:
                return tree::truth(expr.number != 0);
            case ExprKind::integer:
                return tree::number(expr.number);
            case ExprKind::real:
                return decimal_literal(expr.decimal);
            case ExprKind::enum_literal:
                return translate_literal(expr);
            case ExprKind::variable:
                return scope_.variable ? tree::name(scope_.variable(expr.variable))
                                       : refuse_expression(expr, "a variable here");
            case ExprKind::constant:
                return scope_.constant ? tree::name(scope_.constant(expr.constant))
                                       : refuse_expression(expr, "a constant here");
            case ExprKind::trigger_value:
                return tree::name(scope_.received);
            case ExprKind::modulus:
                return tree::call("mod", translate_operands(expr));
            case ExprKind::divide:
                return tree::apply(Op::divide, translate_operands(expr));  // real division in both languages
            case ExprKind::cast:
                return translate_cast(expr);
            case ExprKind::call:
                return translate_call(expr);
            case ExprKind::bound:
                return translate_bound(expr);
            case ExprKind::since:
            case ExprKind::since_entry:
                return refuse_expression(expr, "a clock outside a comparison");
            // clang-format off
            case ExprKind::string: case ExprKind::negate: case ExprKind::logical_not: case ExprKind::iff:
            case ExprKind::implies: case ExprKind::disjunction: case ExprKind::conjunction: case ExprKind::equal:
            case ExprKind::not_equal: case ExprKind::greater: case ExprKind::greater_equal: case ExprKind::less:
            case ExprKind::less_equal: case ExprKind::plus: case ExprKind::minus: case ExprKind::times:
            case ExprKind::if_then_else: case ExprKind::function_value: case ExprKind::apply: case ExprKind::tuple:
            case ExprKind::record: case ExprKind::sequence: case ExprKind::set: case ExprKind::matrix:
            case ExprKind::member: case ExprKind::index: case ExprKind::concat: case ExprKind::is_in:
            case ExprKind::set_range: case ExprKind::forall: case ExprKind::exists: case ExprKind::exists_unique:
            case ExprKind::lambda: case ExprKind::the: case ExprKind::set_comprehension: case ExprKind::let:
            case ExprKind::toolkit: case ExprKind::is_type: case ExprKind::range: case ExprKind::transpose:
                break;
        }
        // clang-format on
        return refuse_expression(expr, "this form of expression");
    }

private:
    ExprPtr refuse_expression(const ir::Expr& expr, const std::string& what) {
        context_.diagnostics.report(rules::unsupported_expression, expr.span, {what, scope_.element});
        return tree::truth(true);
    }

    std::vector<ExprPtr> translate_operands(const ir::Expr& expr) {
        std::vector<ExprPtr> result;
        for (const ir::ExprPtr& operand : expr.args) result.push_back((*this)(*operand));
        return result;
    }

    ExprPtr translate_literal(const ir::Expr& expr) {
        if (!expr.args.empty()) return refuse_expression(expr, "a literal with arguments");
        return tree::name(context_.literal_name(expr.type, expr.number));
    }

    /// Translates a cast. PRISM has one type of numbers, and whole numbers need no rounding. Other numbers are rejected
    /// when they are assigned to a variable.
    ExprPtr translate_cast(const ir::Expr& expr) {
        const bool rounds = context_.system.type(expr.type).kind != ir::TypeKind::real &&
                            context_.system.type(expr.args.front()->type).kind == ir::TypeKind::real;
        const ExprPtr value = (*this)(*expr.args.front());
        return rounds ? tree::call("floor", {value}) : value;
    }

    /// Translates a call of a function. R16: "Functions stay as #CALLFUNC!f$args# until an assertion supplies
    /// pfunctions". Such a placeholder is not valid PRISM. If an assertion or the model defines the result of the
    /// function, the result is inserted instead.
    ExprPtr translate_call(const ir::Expr& expr) {
        const ir::Function& function = context_.system.functions[expr.function.index];
        const auto given = context_.functions.find(function.name);
        if (given != context_.functions.end()) return given->second(translate_operands(expr));
        const ir::Expr* result = result_definition(function);
        if (result == nullptr || depth_ > 0)
            return refuse_expression(
                expr, "a call of the function '" + function.name + "', which no `result == ...` defines");
        Scope inner = scope_;
        inner.bound.clear();
        const std::vector<ExprPtr> arguments = translate_operands(expr);
        for (std::size_t i = 0; i < arguments.size(); ++i) inner.bound[function.parameter_names[i]] = arguments[i];
        Translator translator(context_, inner);
        translator.depth_ = depth_ + 1;
        return translator(*result);
    }

    static const ir::Expr* result_definition(const ir::Function& function) {
        if (function.postconditions.size() != 1) return nullptr;
        const ir::Expr& condition = *function.postconditions.front();
        if (condition.kind != ExprKind::equal) return nullptr;
        const ir::Expr& left = *condition.args[0];
        return left.kind == ExprKind::bound && left.text == "result" ? condition.args[1].get() : nullptr;
    }

    ExprPtr translate_bound(const ir::Expr& expr) {
        const auto found = scope_.bound.find(expr.text);
        return found == scope_.bound.end() ? refuse_expression(expr, "this form of expression") : found->second;
    }

    Context& context_;
    const Scope& scope_;
    unsigned depth_ = 0;  ///< depth of calls inside functions
};

/// Translates a condition without time. R15: "each clock atom becomes true". A clock under a negation is rejected,
/// because RoboTool's treatment of it is unknown.
ExprPtr translate_timeless(Context& context, const Scope& scope, const ir::Expr& expr) {
    bool timed = false;
    ir::visit_operands(expr, [&](const ir::Expr& operand) { timed = timed || ir::reads_clock(operand); });
    if (!timed) return translate_expression(context, scope, expr);
    if (ir::is_comparison(expr.kind)) return tree::truth(true);
    if (expr.kind == ExprKind::conjunction || expr.kind == ExprKind::disjunction)
        return tree::apply(*operator_of(expr.kind), {translate_timeless(context, scope, *expr.args[0]),
                                                     translate_timeless(context, scope, *expr.args[1])});
    context.diagnostics.report(rules::unsupported_expression, expr.span,
                               {"a clock in an operator other than `/\\` and `\\/`", scope.element});
    return tree::truth(true);
}

/// Returns the part of an expression that is not a whole number, or null if there is none.
const ir::Expr* find_fraction(const Context& context, const ir::Expr& expr) {
    const bool real = context.system.type(expr.type).kind == ir::TypeKind::real;
    if (expr.kind == ExprKind::real && expr.decimal.decimals > 0) return &expr;
    if (real && (expr.kind == ExprKind::divide || expr.kind == ExprKind::constant)) return &expr;
    const bool rounds = expr.kind == ExprKind::cast && !real;
    if (rounds || ir::is_comparison(expr.kind)) return nullptr;
    for (const ir::ExprPtr& operand : expr.args)
        if (const ir::Expr* found = find_fraction(context, *operand)) return found;
    return nullptr;
}

}  // namespace

prism::ExprPtr translate_expression(Context& context, const Scope& scope, const ir::Expr& expr) {
    return Translator(context, scope)(expr);
}

prism::ExprPtr translate_condition(Context& context, const Scope& scope, const ir::Expr& expr) {
    return translate_timeless(context, scope, expr);
}

prism::ExprPtr whole_value(Context& context, const Scope& scope, const ir::Expr& expr) {
    if (const ir::Expr* found = find_fraction(context, expr)) {
        context.diagnostics.report(rules::unsupported_expression, found->span,
                                   {"a value that may have a fraction", scope.element});
        return tree::truth(true);
    }
    return translate_expression(context, scope, expr);
}

}  // namespace robochart::prism_emit
