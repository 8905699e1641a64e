// SPDX-License-Identifier: Apache-2.0
// Findings of the type checker for CSPM, as a table.
#pragma once

#include <span>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::cspm::types::rules {

// names
extern const diagnostics::Rule not_in_scope;
extern const diagnostics::Rule declared_twice;
extern const diagnostics::Rule wrong_import;
extern const diagnostics::Rule wrong_kind_of_name;
extern const diagnostics::Rule qualified_pattern;
extern const diagnostics::Rule field_order;
extern const diagnostics::Rule bad_type_variable;

// types
extern const diagnostics::Rule mismatch;
extern const diagnostics::Rule wrong_arity;
extern const diagnostics::Rule not_a_function;
extern const diagnostics::Rule lacks_constraint;
extern const diagnostics::Rule infinite_type;
extern const diagnostics::Rule too_many_fields;
extern const diagnostics::Rule too_few_fields;
extern const diagnostics::Rule open_fields;
extern const diagnostics::Rule subtype_fields;
extern const diagnostics::Rule fixed_extension;

// modules and the rest
extern const diagnostics::Rule module_arguments;
extern const diagnostics::Rule module_cycle;
extern const diagnostics::Rule type_overflow;
extern const diagnostics::Rule print_ill_typed;
extern const diagnostics::Rule bad_pattern;
extern const diagnostics::Rule not_timed;

/// Returns all rules, for `explain`.
[[nodiscard]] std::span<const diagnostics::Rule* const> all_rules();

}  // namespace robochart::cspm::types::rules
