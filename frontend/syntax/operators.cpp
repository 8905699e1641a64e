// SPDX-License-Identifier: Apache-2.0
#include "frontend/syntax/operators.hpp"

#include <algorithm>
#include <array>

namespace robochart::frontend {

namespace {

constexpr std::array<BinaryOperator, 20> operators = {{{"iff", BinaryOp::iff, 0},
                                                       {"=>", BinaryOp::implies, 1},
                                                       {"\\/", BinaryOp::disjunction, 2},
                                                       {"/\\", BinaryOp::conjunction, 3},
                                                       {"==", BinaryOp::equal, compare_level},
                                                       {"!=", BinaryOp::not_equal, compare_level},
                                                       {">", BinaryOp::greater, compare_level},
                                                       {">=", BinaryOp::greater_equal, compare_level},
                                                       {"<", BinaryOp::less, compare_level},
                                                       {"<=", BinaryOp::less_equal, compare_level},
                                                       {"in", BinaryOp::in, compare_level},
                                                       {"+", BinaryOp::plus, plus_level},
                                                       {"-", BinaryOp::minus, plus_level},
                                                       {"*", BinaryOp::times, times_level},
                                                       {"/", BinaryOp::divide, times_level},
                                                       {"%", BinaryOp::modulus, times_level},
                                                       {"cat", BinaryOp::concat, concat_level},
                                                       {"^", BinaryOp::concat, concat_level},
                                                       {"||", BinaryOp::disjunction, 2},
                                                       {"&&", BinaryOp::conjunction, 3}}};

}  // namespace

const BinaryOperator* binary_operator(const Token& token) {
    const auto named = [](std::string_view word) {
        return std::ranges::find_if(operators, [&](const BinaryOperator& candidate) { return candidate.word == word; });
    };
    if (token.escaped) return token.first_on_line ? nullptr : named("^");
    const bool word = token.kind == TokenKind::keyword || token.kind == TokenKind::symbol;
    const auto* found = word ? named(token.text) : operators.end();
    return found == operators.end() ? nullptr : found;
}

}  // namespace robochart::frontend
