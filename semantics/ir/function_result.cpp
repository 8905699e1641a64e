// SPDX-License-Identifier: Apache-2.0
#include "semantics/ir/function_result.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "semantics/ir/visit.hpp"

namespace robochart::ir {
namespace {

bool is_result(const Expr& expr) {
    return expr.kind == ExprKind::bound && expr.text == "result";
}

bool reads_result(const Expr& expr) {
    bool result = false;
    visit_operands(expr, [&](const Expr& operand) { result = result || is_result(operand); });
    return result;
}

/// The indices of the functions that the conditions call.
std::vector<std::size_t> callees_of(const Function& function) {
    std::vector<std::size_t> result;
    for (const auto* conditions : {&function.preconditions, &function.postconditions})
        for (const ExprPtr& condition : *conditions)
            visit_operands(*condition, [&](const Expr& expr) {
                if (expr.function.is_valid()) result.push_back(expr.function.index);
            });
    return result;
}

}  // namespace

ExprPtr result_expression(const Function& function) {
    if (function.postconditions.size() != 1) return nullptr;
    if (std::ranges::find(function.parameter_names, "result") != function.parameter_names.end()) return nullptr;
    const ExprPtr& condition = function.postconditions[0];
    const bool equates = condition && (condition->kind == ExprKind::equal || condition->kind == ExprKind::iff);
    if (!equates || condition->args.size() != 2) return nullptr;
    for (const std::size_t side : {0U, 1U}) {
        const ExprPtr& body = condition->args[1 - side];
        const Expr& other = *condition->args[side];
        const bool has_type = other.type == function.result && body->type == function.result;
        if (is_result(other) && has_type && !reads_result(*body)) return body;
    }
    return nullptr;
}

bool is_recursive(const System& system, const Function& function) {
    std::vector<bool> is_called(system.functions.size());
    std::vector<std::size_t> open = callees_of(function);
    while (!open.empty()) {
        const std::size_t callee = open.back();
        open.pop_back();
        if (is_called.at(callee)) continue;
        is_called[callee] = true;
        if (&system.functions[callee] == &function) return true;
        for (const std::size_t next : callees_of(system.functions[callee])) open.push_back(next);
    }
    return false;
}

}  // namespace robochart::ir
