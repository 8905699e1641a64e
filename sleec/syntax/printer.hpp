// SPDX-License-Identifier: Apache-2.0
// Prints SLEEC trees as text that parses to the same tree.
#pragma once

#include <string>

#include "sleec/syntax/syntax.hpp"

namespace robochart::sleec {

/// A whole file in its dialect: one line per definition; a rule and each of its defeaters on separate lines.
[[nodiscard]] std::string print(const RuleFile& file);
/// A rule on one line, without its name.
[[nodiscard]] std::string print(const Rule& rule);
/// A condition; if it contains both `and` and `or`, parentheses show their order.
[[nodiscard]] std::string print(const ExprPtr& expr);
/// A response on one line.
[[nodiscard]] std::string print(const ResponsePtr& response);

}  // namespace robochart::sleec
