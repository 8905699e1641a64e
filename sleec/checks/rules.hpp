// SPDX-License-Identifier: Apache-2.0
// Diagnostics about names and types of SLEEC rules, as a table.
#pragma once

#include <span>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::sleec::rules {

extern const diagnostics::Rule unknown_name;
extern const diagnostics::Rule wrong_kind;
extern const diagnostics::Rule declared_twice;
extern const diagnostics::Rule rule_named_twice;
extern const diagnostics::Rule wrong_type;
extern const diagnostics::Rule literal_by_place;
extern const diagnostics::Rule circular_constant;
extern const diagnostics::Rule empty_interval;

/// All rules, for `explain`.
[[nodiscard]] std::span<const diagnostics::Rule* const> check_rule_table();

}  // namespace robochart::sleec::rules
