// SPDX-License-Identifier: Apache-2.0
// Prints parts of SLEEC trees in the notation of SLEEC-TK, as text that parses to the same tree.
#pragma once

#include <string>

#include "claims/sleec/syntax/syntax.hpp"

namespace robochart::sleec {

/// Prints a rule on one line, without its name.
[[nodiscard]] std::string print(const Rule& rule);
/// Prints an event with its arguments.
[[nodiscard]] std::string print(const EventName& event);
/// Prints a condition. If it contains both `and` and `or`, parentheses show their order.
[[nodiscard]] std::string print(const ExprPtr& expr);
/// Prints a response on one line.
[[nodiscard]] std::string print(const ResponsePtr& response);

}  // namespace robochart::sleec
