// SPDX-License-Identifier: Apache-2.0
// Builds the names and types of random syntax trees.
#include <utility>

#include "frontend/syntax/lexer.hpp"
#include "tests/random_models/syntax/syntax_builder.hpp"

namespace robochart::random_models {

using namespace frontend;

/// Returns a plain name in most cases, sometimes a reserved word, or a word that is reserved only in some positions.
std::string SyntaxBuilder::name() {
    static const std::vector<std::string> plain = {"a",   "b",   "x",     "y", "speed", "Move",     "S0", "_private",
                                                   "v_1", "nat", "Wheel", "t", "N9",    "position", "e"};
    static const std::vector<std::string> words = {
        "Set",  "Seq",    "timed",   "untimed",   "assertion", "csp",     "model", "constant",
        "of",   "with",   "and",     "label",     "does",      "value",   "free",  "deadlock",
        "prob", "equals", "refines", "reachable", "rewards",   "formula", "core",  "result_"};
    const std::size_t way = random_.below(20);
    if (way == 0) return std::string(random_.pick(reserved_words()));
    return random_.pick(way == 1 ? words : plain);
}

QualifiedName SyntaxBuilder::simple() {
    QualifiedName result;
    result.parts.push_back(name());
    return result;
}

QualifiedName SyntaxBuilder::qualified() {
    QualifiedName result = simple();
    while (random_.chance(25)) result.parts.push_back(name());
    return result;
}

TypeExprPtr SyntaxBuilder::type(std::size_t depth) {
    auto result = std::make_unique<TypeExpr>();
    const auto add = [&](std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) result->args.push_back(type(depth - 1));
    };
    constexpr std::size_t kinds = 9;
    if (depth == 0)
        result->kind = random_.chance(80) ? TypeKind::name : TypeKind::variable;
    else
        result->kind = static_cast<TypeKind>(random_.below(kinds));
    switch (result->kind) {
        case TypeKind::name:
            result->name = qualified();
            break;
        case TypeKind::variable:
            result->name = simple();
            break;
        case TypeKind::sequence:
        case TypeKind::set:
            add(1);
            break;
        case TypeKind::product:
            add(random_.between(2, 3));
            break;
        case TypeKind::function:
        case TypeKind::relation:
            add(2);
            break;
        case TypeKind::vector:
        case TypeKind::matrix:
            add(1);
            for (std::size_t i = result->kind == TypeKind::vector ? 1 : 2; i > 0; --i)
                result->sizes.push_back(at(16, depth - 1));
            break;
    }
    return result;
}

VariablePtr SyntaxBuilder::variable(DeclKind kind, std::size_t depth) {
    auto result = std::make_unique<Variable>(kind);
    result->name = name();
    result->type_expr = type(depth);
    const bool may_have_value = kind == DeclKind::variable || kind == DeclKind::constant;
    if (may_have_value && random_.chance(50)) result->initial = expression(depth);
    return result;
}

}  // namespace robochart::random_models
