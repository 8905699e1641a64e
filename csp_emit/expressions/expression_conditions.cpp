// SPDX-License-Identifier: Apache-2.0
// Translates the preconditions of the functions that an expression calls: `pre_f(args) & ...` before the statement or
// transition (semantics 3.5). Preconditions of inner calls come first, because the precondition of an outer call may
// need their values. Under a binder, the precondition is required for every value for which the body is evaluated.
#include "csp_emit/base/types.hpp"
#include "csp_emit/expressions/translator.hpp"
#include "semantics/evaluate/preconditions.hpp"
#include "semantics/evaluate/toolkit.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;
using ir::ExprKind;

namespace {

void append_all(b::Exprs& list, const b::Exprs& more) {
    list.insert(list.end(), more.begin(), more.end());
}

}  // namespace

b::Exprs Translator::preconditions(const ir::Expr& expr) const {
    if (ir::binds_names(expr.kind)) return bound_preconditions(expr);
    b::Exprs result;
    for (std::size_t i = 0; i < expr.args.size(); ++i) {
        if (!expr.args[i]) continue;
        b::Exprs inner = preconditions(*expr.args[i]);
        if (expr.kind == ExprKind::let && i > 0 && !inner.empty()) inner = {bind_let(expr, i, b::all_of(inner))};
        append_all(result, inner);
    }
    if (expr.kind == ExprKind::toolkit && ir::toolkit_precondition(expr.text))
        result.push_back(b::apply(b::name("pre_" + expr.text), translate_operands(expr)));
    if (expr.kind == ExprKind::call) {
        const ir::Function& function = project_.system.functions.at(expr.function.index);
        if (!function.preconditions.empty())
            result.push_back(b::apply(b::name("pre_" + function_name(function)), call_arguments(expr)));
    }
    return result;
}

/// Returns the preconditions inside a binder, quantified over the bound variables. Those of the predicate must be true
/// for all values, and those of the body for the values that satisfy the predicate.
b::Exprs Translator::bound_preconditions(const ir::Expr& expr) const {
    b::Exprs result;
    std::vector<cspm::Clause> clauses = make_generators(expr);
    const auto never_false = [&](const b::Exprs& conditions) {
        auto counterexamples = clauses;
        counterexamples.push_back(b::condition(b::logical_not(b::all_of(conditions))));
        result.push_back(b::call("empty", {b::set_comprehension({bound_tuple(expr)}, counterexamples)}));
    };
    const b::Exprs of_predicate = expr.args.at(0) ? preconditions(*expr.args[0]) : b::Exprs{};
    if (!of_predicate.empty()) never_false(of_predicate);
    if (expr.args.size() < 2) return result;
    const b::Exprs of_body = preconditions(*expr.args[1]);
    if (expr.args[0]) clauses.push_back(b::condition(translate_operand(expr, 0)));
    if (!of_body.empty()) never_false(of_body);
    return result;
}

}  // namespace robochart::csp_emit
