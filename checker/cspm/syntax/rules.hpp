// SPDX-License-Identifier: Apache-2.0
// Diagnostics of the CSPM reader, as a table.
#pragma once

#include <span>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::cspm::rules {

extern const diagnostics::Rule unexpected_token;
extern const diagnostics::Rule bad_character;
extern const diagnostics::Rule foreign_name;
extern const diagnostics::Rule open_comment;
extern const diagnostics::Rule open_literal;
extern const diagnostics::Rule big_number;
extern const diagnostics::Rule bad_property;
extern const diagnostics::Rule too_deep;
extern const diagnostics::Rule not_associative;
extern const diagnostics::Rule misplaced_declaration;
extern const diagnostics::Rule annotation_unused;
extern const diagnostics::Rule annotation_repeated;
extern const diagnostics::Rule bad_annotation;
extern const diagnostics::Rule option_repeated;
extern const diagnostics::Rule bad_include;
extern const diagnostics::Rule include_failed;
extern const diagnostics::Rule include_cycle;
extern const diagnostics::Rule arrow_comment;

/// Returns all rules, for `explain`.
[[nodiscard]] std::span<const diagnostics::Rule* const> all_rules();

}  // namespace robochart::cspm::rules
