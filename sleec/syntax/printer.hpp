// SLEEC trees written as text that reads back as the same tree.
#pragma once

#include <string>

#include "sleec/syntax/syntax.hpp"

namespace robochart::sleec {

/// A whole file in its dialect: a line for each definition; a rule, and each of its defeaters, on lines of their own.
[[nodiscard]] std::string print(const RuleFile& file);
/// A rule on one line, without its name.
[[nodiscard]] std::string print(const Rule& rule);
/// A condition; parentheses show how `and` and `or` are read where both occur.
[[nodiscard]] std::string print(const ExprPtr& expr);
/// A response on one line.
[[nodiscard]] std::string print(const ResponsePtr& response);

}  // namespace robochart::sleec
