// SPDX-License-Identifier: Apache-2.0
// See conditions.hpp.
#include "claims/checks/conditions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "claims/checks/rules.hpp"

namespace robochart::claims {
namespace {

bool is_comparison(Op op) {
    return op == Op::less || op == Op::less_equal || op == Op::greater || op == Op::greater_equal;
}

}  // namespace

Condition operand_of(Operand operand, std::size_t index) {
    Condition result;
    result.operand = operand;
    result.index = index;
    return result;
}

Condition constant_of(Fraction value) {
    Condition result;
    result.operand = Operand::constant;
    result.value = value;
    return result;
}

Condition operation(Op op, std::vector<Condition> parts) {
    Condition result;
    result.op = op;
    result.parts = std::move(parts);
    return result;
}

void ConditionResolver::refuse(Span span, std::string text) const {
    diagnostics_.report(rules::wrong_value, span, {std::move(text)});
    throw ClaimError{};
}

Typed ConditionResolver::typed_operand(Condition condition, ir::TypeId type, Span span) const {
    condition.type = type;
    const ir::Type& of = system_.type(type);
    switch (of.kind) {
        case ir::TypeKind::nat:
        case ir::TypeKind::integer:
        case ir::TypeKind::real:
            return {std::move(condition), Sort::number, {}};
        case ir::TypeKind::boolean:
            return {std::move(condition), Sort::truth, {}};
        case ir::TypeKind::enumeration:
            if (std::ranges::all_of(of.literal_args, [](const auto& arguments) { return arguments.empty(); }))
                return {std::move(condition), Sort::literal, type};
            break;
        case ir::TypeKind::string:
        case ir::TypeKind::given:
        case ir::TypeKind::sequence:
        case ir::TypeKind::set:
        case ir::TypeKind::product:
        case ir::TypeKind::record:
        case ir::TypeKind::function:
        case ir::TypeKind::relation:
        case ir::TypeKind::vector:
        case ir::TypeKind::matrix:
        case ir::TypeKind::unit:
            break;
    }
    refuse(span, fmt::format("conditions are about numbers, truth values and literals, not about values of the type {}",
                             of.name));
}

std::optional<Typed> ConditionResolver::find_literal(const std::string& text) const {
    std::optional<Typed> found;
    for (std::uint32_t i = 0; i < system_.types.size(); ++i) {
        const ir::Type& type = system_.types[i];
        if (type.kind != ir::TypeKind::enumeration) continue;
        for (std::size_t label = 0; label < type.labels.size(); ++label) {
            const std::string name = type.name + "::" + type.labels[label];
            if (text != type.labels[label] && text != name && text != type.package + "::" + name) continue;
            if (found) return std::nullopt;
            found = Typed{constant_of(Fraction(static_cast<std::int64_t>(label))), Sort::literal, ir::TypeId{i}};
            found->condition.type = ir::TypeId{i};
        }
    }
    return found;
}

Typed ConditionResolver::resolve(const Expr& expr, const Leaf& leaf) const {
    try {
        if (expr.op == Op::number) return {constant_of(Fraction::of_decimal(expr.text)), Sort::number, {}};
    } catch (const NotComputable& error) {
        refuse(expr.span, error.what());
    }
    if (expr.op == Op::truth) {
        Condition truth = constant_of(Fraction(expr.text == "true" ? 1 : 0));
        truth.type = ir::boolean_type;
        return {std::move(truth), Sort::truth, {}};
    }
    if (expr.op == Op::name || expr.op == Op::last || expr.op == Op::in_state) return leaf(expr);
    return resolve_operator(expr, leaf);
}

Condition ConditionResolver::resolve_truth(const Expr& expr, const Leaf& leaf) const {
    Typed result = resolve(expr, leaf);
    if (result.sort != Sort::truth) refuse(expr.span, "this is no condition");
    return std::move(result.condition);
}

Typed ConditionResolver::resolve_operator(const Expr& expr, const Leaf& leaf) const {
    std::vector<Typed> parts;
    for (const ExprPtr& part : expr.parts) parts.push_back(resolve(*part, leaf));
    const auto require = [&](Sort sort, const char* what) {
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (parts[i].sort != sort) refuse(expr.parts[i]->span, fmt::format("this is no {}", what));
    };
    Sort sort = Sort::truth;
    if (expr.op == Op::negation || expr.op == Op::conjunction || expr.op == Op::disjunction) {
        require(Sort::truth, "condition");
    } else if (expr.op == Op::equal || expr.op == Op::unequal) {
        if (parts[0].sort != parts[1].sort || parts[0].type != parts[1].type)
            refuse(expr.span, "values of different types are compared");
    } else {
        require(Sort::number, "number");
        if (!is_comparison(expr.op)) sort = Sort::number;
    }
    std::vector<Condition> conditions;
    for (Typed& part : parts) conditions.push_back(std::move(part.condition));
    return {operation(expr.op, std::move(conditions)), sort, {}};
}

}  // namespace robochart::claims
