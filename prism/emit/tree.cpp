// SPDX-License-Identifier: Apache-2.0
#include "prism/emit/tree.hpp"

#include <utility>

namespace robochart::prism_emit::tree {

ExprPtr name(const std::string& text) {
    return prism::make_expr(Op::name, {}, {}, text);
}

ExprPtr number(std::int64_t value) {
    if (value >= 0) return prism::make_expr(Op::integer, {}, {}, std::to_string(value));
    return apply(Op::minus, {prism::make_expr(Op::integer, {}, {}, std::to_string(value).substr(1))});
}

ExprPtr truth(bool value) {
    return prism::make_expr(Op::boolean, {}, {}, value ? "true" : "false");
}

ExprPtr apply(Op op, std::vector<ExprPtr> operands) {
    return prism::make_expr(op, {}, std::move(operands));
}

ExprPtr call(const std::string& function, std::vector<ExprPtr> operands) {
    return prism::make_expr(Op::call, {}, std::move(operands), function);
}

ExprPtr is(const std::string& variable, const std::string& value) {
    return apply(Op::equal, {name(variable), name(value)});
}

bool is_true(const ExprPtr& expr) {
    return expr->op == Op::boolean && expr->text == "true";
}

ExprPtr all_of(const std::vector<ExprPtr>& operands) {
    ExprPtr result;
    for (const ExprPtr& operand : operands) {
        if (!operand || is_true(operand)) continue;
        result = result ? apply(Op::conjunction, {result, operand}) : operand;
    }
    return result ? result : truth(true);
}

prism::Assignment set(const std::string& variable, ExprPtr value) {
    return {{variable, {}}, std::move(value)};
}

prism::Assignment set(const std::string& variable, const std::string& value) {
    return set(variable, name(value));
}

prism::Constant constant(const std::string& name, std::int64_t value) {
    return {prism::Type::integer, {name, {}}, number(value)};
}

prism::Variable range(const std::string& name, std::int64_t low, std::int64_t high, ExprPtr initial) {
    return {{name, {}}, prism::Type::integer, number(low), number(high), std::move(initial)};
}

prism::Variable boolean(const std::string& name, ExprPtr initial) {
    return {{name, {}}, prism::Type::boolean, nullptr, nullptr, std::move(initial)};
}

prism::Command command(const std::string& action, ExprPtr guard, std::vector<prism::Assignment> assignments) {
    return {{action, {}}, std::move(guard), {{nullptr, std::move(assignments), {}}}, {}};
}

}  // namespace robochart::prism_emit::tree
