// SPDX-License-Identifier: Apache-2.0
// The rule table of this component: constructs without a CSP semantics here, and errors in CSP blocks.
#pragma once

#include <span>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::csp_emit::rules {

extern const diagnostics::Rule unsupported;              // RC-C01
extern const diagnostics::Rule recursive_call;           // RC-C02
extern const diagnostics::Rule missing_in_caller;        // RC-C03
extern const diagnostics::Rule reserved_name;            // RC-C04
extern const diagnostics::Rule too_many_points;          // RC-C06
extern const diagnostics::Rule instantiations_replaced;  // RC-C07
extern const diagnostics::Rule constant_without_use;     // RC-C08
extern const diagnostics::Rule name_of_another;          // RC-C09
extern const diagnostics::Rule one_name_for_two;         // RC-C10
extern const diagnostics::Rule probabilistic_choice;     // RC-C21
extern const diagnostics::Rule block_without_process;    // RC-C11
extern const diagnostics::Rule inputs_hidden;            // RC-C12
extern const diagnostics::Rule definition_unread;        // RC-C13
extern const diagnostics::Rule block_of_other_time;      // RC-C14
extern const diagnostics::Rule name_of_robotool;         // RC-C15
extern const diagnostics::Rule name_of_machine_decides;  // RC-C17
extern const diagnostics::Rule two_values_of_constant;   // RC-C18

/// Every rule above, in order of code.
[[nodiscard]] std::span<const diagnostics::Rule* const> all();

}  // namespace robochart::csp_emit::rules
