// SPDX-License-Identifier: Apache-2.0
// Findings of the SLEEC parser, as a table.
#pragma once

#include <span>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::sleec::rules {

extern const diagnostics::Rule unexpected_token;
extern const diagnostics::Rule bad_character;
extern const diagnostics::Rule open_comment;
extern const diagnostics::Rule big_number;
extern const diagnostics::Rule too_deep;
extern const diagnostics::Rule not_supported;
extern const diagnostics::Rule unreadable;
extern const diagnostics::Rule other_dialect;
extern const diagnostics::Rule extension;
extern const diagnostics::Rule mixed_operators;

/// All rules, for `explain`.
[[nodiscard]] std::span<const diagnostics::Rule* const> syntax_rule_table();

}  // namespace robochart::sleec::rules
