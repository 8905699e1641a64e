// SPDX-License-Identifier: Apache-2.0
// The rule table of the parser: all errors in a text that are found before names are resolved.
#pragma once

#include <vector>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::frontend::syntax {

using diagnostics::Rule;

extern const Rule unexpected, too_deep, open_comment, open_string, strange_character, huge_integer, long_real, not_text,
    legacy_trigger, blank_in_set, reserved_name, bare_value, open_csp_block, too_many, bare_quantifier, late_package,
    parameter_list, clause_order, stray_bracket, ragged_matrix, single_equal, colon_equal, too_long, c_operator,
    plain_name, needs_parentheses, neural, clause_twice, trailing_semicolon, legacy_list, clock_time, hyphenated,
    foreign_assertion, other_notation, probabilistic_clause_order;
extern const Rule unreadable, empty_input, no_files, empty_file;

/// All rules, sorted by code.
[[nodiscard]] const std::vector<const Rule*>& rule_list();
/// True if the rule is one of parsing.
[[nodiscard]] bool is_syntax(const Rule&);

}  // namespace robochart::frontend::syntax
