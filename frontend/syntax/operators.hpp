// The binary operators of expressions and how tightly they bind (RoboChart.xtext: Expression to CallExp).
#pragma once

#include <string_view>

#include "frontend/syntax/ast.hpp"
#include "frontend/syntax/lexer.hpp"

namespace robochart::frontend {

/// A higher level binds tighter. Binary operators associate to the left.
struct BinaryOperator {
    std::string_view word;
    BinaryOp op;
    int level;
};

// Levels of the operators that stand alone between those of the table, and of those that are asked for by name.
inline constexpr int not_level = 4;
inline constexpr int compare_level = 5;
inline constexpr int the_level = 6;
inline constexpr int let_level = 7;
inline constexpr int if_level = 8;
inline constexpr int cast_level = 9;  ///< `as` and `is`, whose right side is a type
inline constexpr int plus_level = 10;
inline constexpr int times_level = 11;
inline constexpr int concat_level = 12;  ///< the tightest

/// The operator that a token behind an operand is; null if it is none. `^b` on the operand's line, which the lexer
/// takes for an escaped name, is one; `||` and `&&`, slips of those who write C, are read as meant.
[[nodiscard]] const BinaryOperator* binary_operator(const Token& token);

}  // namespace robochart::frontend
