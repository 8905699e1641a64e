// SPDX-License-Identifier: Apache-2.0
// Diagnostics of the PRISM reader, as a table.
#pragma once

#include <span>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::prism::rules {

extern const diagnostics::Rule unexpected_token;
extern const diagnostics::Rule bad_character;
extern const diagnostics::Rule open_label;
extern const diagnostics::Rule big_number;
extern const diagnostics::Rule too_deep;
extern const diagnostics::Rule not_supported;
extern const diagnostics::Rule given_twice;
extern const diagnostics::Rule unreadable;
extern const diagnostics::Rule unclear_operand;

/// Returns all rules, for `explain`.
[[nodiscard]] std::span<const diagnostics::Rule* const> syntax();

}  // namespace robochart::prism::rules
