// SPDX-License-Identifier: Apache-2.0
// Errors in the evaluation of constants, states and rewards of a PRISM model, as a table.
#pragma once

#include <span>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::prism::rules {

extern const diagnostics::Rule constant_open;
extern const diagnostics::Rule arithmetic;
extern const diagnostics::Rule out_of_range;
extern const diagnostics::Rule bad_probability;
extern const diagnostics::Rule wrong_sum;
extern const diagnostics::Rule empty_range;
extern const diagnostics::Rule no_initial_state;
extern const diagnostics::Rule deadlocks;
extern const diagnostics::Rule negative_reward;
extern const diagnostics::Rule bad_steps;
extern const diagnostics::Rule too_close;
extern const diagnostics::Rule normalised;
extern const diagnostics::Rule not_exact;
extern const diagnostics::Rule bad_bound;
extern const diagnostics::Rule left_out;

/// Returns all rules, for `explain`.
[[nodiscard]] std::span<const diagnostics::Rule* const> explore();

}  // namespace robochart::prism::rules
