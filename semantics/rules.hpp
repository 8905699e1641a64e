// SPDX-License-Identifier: Apache-2.0
// The rule table of this component: constructs that the IR cannot express, and mistakes in an instantiation.
#pragma once

#include <span>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::ir::rules {

extern const diagnostics::Rule unsupported_construct;        // RC-S01
extern const diagnostics::Rule recursive_operation;          // RC-S02
extern const diagnostics::Rule number_too_large;             // RC-S03
extern const diagnostics::Rule too_deep;                     // RC-S04
extern const diagnostics::Rule unresolved;                   // RC-S05
extern const diagnostics::Rule unknown_constant_option;      // RC-S10
extern const diagnostics::Rule bad_constant_value;           // RC-S11
extern const diagnostics::Rule unknown_range_option;         // RC-S12
extern const diagnostics::Rule bad_range;                    // RC-S13
extern const diagnostics::Rule ranges_not_nested;            // RC-S14
extern const diagnostics::Rule range_too_large;              // RC-S15
extern const diagnostics::Rule scale_too_large;              // RC-S16
extern const diagnostics::Rule literal_outside_range;        // RC-S17
extern const diagnostics::Rule function_without_definition;  // RC-S18
extern const diagnostics::Rule ambiguous_constant;           // RC-S19
extern const diagnostics::Rule function_by_contract;         // RC-S20
extern const diagnostics::Rule no_beginning;                 // RC-S21
extern const diagnostics::Rule declared_twice;               // RC-S22
extern const diagnostics::Rule no_literals;                  // RC-S23
extern const diagnostics::Rule constant_named_twice;         // RC-S24

/// All rules above, in order of code.
[[nodiscard]] std::span<const diagnostics::Rule* const> all();

}  // namespace robochart::ir::rules
