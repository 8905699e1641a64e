// SPDX-License-Identifier: Apache-2.0
// Describes clipped calls. A clipping function returns its first operand if the result is not a value of the type.
#include "csp_emit/expressions/clipping.hpp"

#include <array>

namespace robochart::csp_emit {
namespace {

struct Operator {
    const char* function;
    const char* sign;
};
constexpr std::array operators{Operator{"Plus", "+"},     Operator{"Minus", "-"},   Operator{"Mult", "*"},
                               Operator{"Div", "/"},      Operator{"Modulus", "%"}, Operator{"Neg", "-"},
                               Operator{"RealMult", "*"}, Operator{"RealDiv", "/"}};

const Operator* find_operator(const std::string& function) {
    for (const Operator& candidate : operators)
        if (function == candidate.function) return &candidate;
    return nullptr;
}

/// True if the operation without clipping returns its first operand.
bool keeps_first_operand(const std::string& function, std::int64_t a, std::int64_t b, std::int64_t scale) {
    if (function == "Plus" || function == "Minus") return b == 0;
    if (function == "Mult") return a == 0 || b == 1;
    if (function == "RealMult") return a == 0 || b == scale;
    if (function == "Div") return b == 1 || a == 0 || (a == -1 && b > 1);
    if (function == "RealDiv") return b == scale || a == 0;
    if (function == "Modulus") return b > 0 ? a >= 0 && a < b : a <= 0 && a > b;
    return a == 0;
}

/// Returns the text of a number in the script. A real with a scale is written as a fraction.
std::string number_text(const std::string& function, std::int64_t value, std::int64_t scale) {
    const bool real = scale != 1 && function.rfind("Real", 0) == 0;
    return real ? std::to_string(value) + "/" + std::to_string(scale) : std::to_string(value);
}

}  // namespace

cspm::ExprPtr with_place(const cspm::ExprPtr& tree, diagnostics::Span span) {
    if (!tree || tree->span.is_known() || !span.is_known()) return tree;
    const bool leaf = tree->args.empty() && tree->clauses.empty();
    if (leaf) return tree;
    cspm::Expr copy = *tree;
    using Kind = cspm::ExprKind;
    const bool may_fail = copy.kind == Kind::apply || copy.kind == Kind::divide || copy.kind == Kind::modulus;
    if (may_fail) copy.span = span;
    for (auto& part : copy.args) part = with_place(part, span);
    for (auto& clause : copy.clauses) clause.value = with_place(clause.value, span);
    return std::make_shared<const cspm::Expr>(std::move(copy));
}

std::optional<std::string> reached_bound(const Emission& emission, const ir::Instantiation& instantiation,
                                         const cspm::ObservedCall& call) {
    if (!emission.bounded.contains(call.function)) return std::nullopt;
    const Operator* arithmetic = find_operator(call.function);
    if (arithmetic == nullptr) {
        const std::string value = call.result ? " and is taken as " + std::to_string(*call.result) : "";
        return call.function + " has no body here" + value;
    }
    const bool unary = call.function == "Neg";
    if (call.values.empty() || !call.values[0] || !call.result || *call.result != *call.values[0]) return std::nullopt;
    const std::int64_t left = *call.values[0];
    const std::int64_t right = unary || call.values.size() < 2 ? 0 : call.values[1].value_or(0);
    if (keeps_first_operand(call.function, left, right, instantiation.scale)) return std::nullopt;
    const auto number = [&](std::int64_t value) { return number_text(call.function, value, instantiation.scale); };
    const std::string operation =
        unary ? "-(" + number(left) + ")" : number(left) + " " + arithmetic->sign + " " + number(right);
    return operation + " leaves its type and is taken as " + number(left);
}

}  // namespace robochart::csp_emit
