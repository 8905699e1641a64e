// SPDX-License-Identifier: Apache-2.0
// Writes preconditions of the functions that an expression calls (semantics 3.5). The code tests the same preconditions
// as the semantics, in the same order. Preconditions of inner calls come first, because those of an outer call may need
// their values. Under a binder they are tested for every value for which the body is evaluated. They are tested in both
// operands of a logical operator, even if one operand decides the result. A call is evaluated only after its
// preconditions have been found true.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cpp_emit/expressions/expression.hpp"
#include "cpp_emit/plan/list_capacities.hpp"
#include "cpp_emit/plan/types.hpp"
#include "cpp_emit/plan/views.hpp"
#include "semantics/evaluate/preconditions.hpp"

namespace robochart::cpp_emit {

using ir::ExprKind;

namespace {

CppExpr all_of(const std::vector<CppExpr>& conditions) {
    CppExpr result;
    for (const CppExpr& condition : conditions) result = conjunction(result, condition);
    return result;
}

void append_all(std::vector<CppExpr>& list, const std::vector<CppExpr>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

}  // namespace

std::vector<CppExpr> ExpressionWriter::preconditions(const ir::Expr& expr) const {
    if (ir::binds_names(expr.kind)) return bound_preconditions(expr);
    std::vector<CppExpr> result;
    for (std::size_t i = 0; i < expr.args.size(); ++i) {
        if (!expr.args[i]) continue;
        std::vector<CppExpr> inner = preconditions(*expr.args[i]);
        if (expr.kind == ExprKind::let && i > 0 && !inner.empty())
            inner = {CppExpr(bound_by_let(expr, i, all_of(inner).whole_text()))};
        append_all(result, inner);
    }
    const bool called = expr.kind == ExprKind::toolkit || expr.kind == ExprKind::call;
    if (!called || !ir::precondition_can_fail(generation_.system, generation_.inst, unit_.constants, expr))
        return result;
    if (expr.kind == ExprKind::call)
        result.emplace_back(fmt::format("{}({})", hook_of(expr.function).precondition, call_arguments(expr)));
    else if (is_view(generation_.system, *expr.args.at(0)))
        result.push_back(view_has_elements(*expr.args[0]));
    else
        result.emplace_back(fmt::format("{}.size() > 0", write_operand(*expr.args[0])), Binding::order);
    return result;
}

/// Returns preconditions for all values of the bound variables: those of the predicate for all values, and those of the
/// body for the values that satisfy the predicate.
std::vector<CppExpr> ExpressionWriter::bound_preconditions(const ir::Expr& expr) const {
    std::vector<CppExpr> result;
    const auto never_false = [&](const CppExpr& where, const std::vector<CppExpr>& conditions) {
        const CppExpr found = conjunction(where, negation(all_of(conditions)));
        result.push_back(negation(CppExpr(write_any(expr, 0, fmt::format("return {};", found.whole_text())))));
    };
    const std::vector<CppExpr> of_predicate = expr.args.at(0) ? preconditions(*expr.args[0]) : std::vector<CppExpr>{};
    if (!of_predicate.empty()) never_false({}, of_predicate);
    if (expr.args.size() < 2 || !expr.args[1]) return result;
    const std::vector<CppExpr> of_body = preconditions(*expr.args[1]);
    if (!of_body.empty()) never_false(predicate_of(expr), of_body);
    return result;
}

CppExpr ExpressionWriter::precondition_test(const ir::Expr& expr) const {
    const std::vector<CppExpr> conditions = preconditions(expr);
    if (conditions.empty() || generation_.mutation.hits(Fault::function_precondition_dropped, &unit_, &expr)) return {};
    return all_of(conditions);
}

CppExpr ExpressionWriter::expression_asked(const ir::Expr& condition) const {
    const CppExpr defined = conjunction(precondition_test(condition), cpp_expression(condition));
    bool builds_list = false;
    visit_values(generation_.system, condition,
                 [&](const ir::Expr& part) { builds_list = builds_list || may_overflow(generation_.system, part); });
    return builds_list ? conjunction(defined, CppExpr("lists_fit()")) : defined;
}

void write_preconditions(const Generation& generation, CodeWriter& out) {
    const ExpressionWriter expressions(generation, generation.component.root_unit());
    for (const FunctionHook& hook : generation.component.functions) {
        if (!hook.guarded) continue;
        const ir::Function& function = generation.system.functions[hook.id.index];
        std::vector<std::string> parameters;
        std::vector<CppExpr> conditions;
        for (std::size_t i = 0; i < function.parameters.size(); ++i)
            parameters.push_back(fmt::format("[[maybe_unused]] const {}& {}",
                                             cpp_type(generation.system, function.parameters[i]),
                                             bound_identifier(function.parameter_names[i])));
        for (const ir::ExprPtr& condition : function.preconditions)
            conditions.push_back(expressions.expression_asked(*condition));
        out.gap();
        out.doc(fmt::format("The precondition of {}: what uses the function waits until it holds.", function.name));
        out.open(fmt::format("[[nodiscard]] bool {}({}) noexcept {{", hook.precondition, fmt::join(parameters, ", ")));
        out.line(fmt::format("return {};", all_of(conditions).whole_text()));
        out.close();
    }
}

}  // namespace robochart::cpp_emit
