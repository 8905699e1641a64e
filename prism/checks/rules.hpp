// SPDX-License-Identifier: Apache-2.0
// Static rules of PRISM models and properties, as a table.
#pragma once

#include <span>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::prism::rules {

extern const diagnostics::Rule not_declared;
extern const diagnostics::Rule declared_twice;
extern const diagnostics::Rule wrong_type;
extern const diagnostics::Rule wrong_function;
extern const diagnostics::Rule defined_by_itself;
extern const diagnostics::Rule not_constant;
extern const diagnostics::Rule foreign_variable;
extern const diagnostics::Rule global_written;
extern const diagnostics::Rule assigned_twice;
extern const diagnostics::Rule bad_renaming;
extern const diagnostics::Rule bad_composition;
extern const diagnostics::Rule two_initials;
extern const diagnostics::Rule own_label;
extern const diagnostics::Rule misplaced;
extern const diagnostics::Rule no_rewards;
extern const diagnostics::Rule no_optimum;
extern const diagnostics::Rule no_module;
extern const diagnostics::Rule expands_too_far;

/// Returns all rules, for `explain`.
[[nodiscard]] std::span<const diagnostics::Rule* const> checks();

}  // namespace robochart::prism::rules
