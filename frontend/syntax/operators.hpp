// SPDX-License-Identifier: Apache-2.0
// Defines the binary operators of expressions and their precedence (RoboChart.xtext: Expression to CallExp).
#pragma once

#include <string_view>

#include "frontend/syntax/ast.hpp"
#include "frontend/syntax/lexer.hpp"

namespace robochart::frontend {

/// A binary operator. It is left-associative, and binds more tightly than operators of lower levels.
struct BinaryOperator {
    std::string_view word;
    BinaryOp op;
    int level;
};

// Levels of operators that are not in the table, and levels that other code refers to by name.
inline constexpr int not_level = 4;
inline constexpr int compare_level = 5;
inline constexpr int the_level = 6;
inline constexpr int let_level = 7;
inline constexpr int if_level = 8;
inline constexpr int cast_level = 9;  ///< `as` and `is`, whose right side is a type
inline constexpr int plus_level = 10;
inline constexpr int times_level = 11;
inline constexpr int concat_level = 12;  ///< the level of the operator that binds most tightly

/// Returns the operator that a token after an operand denotes, or null if the token is not an operator. `^b` on the
/// operand's line, which the lexer reads as an escaped name, is the operator `^`. C's `||` and `&&` are read as `\/`
/// and `/\`.
[[nodiscard]] const BinaryOperator* binary_operator(const Token& token);

}  // namespace robochart::frontend
