// SPDX-License-Identifier: Apache-2.0
// The rule table of the resolved model: names, well-formedness and types (language reference 2). Codes are the
// published ones if they exist; codes of this project begin with RC-. Two rows may share a code if they report the same
// rule in different circumstances.
#pragma once

#include <vector>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::frontend::rules {

using diagnostics::Rule;

// rules_names.cpp
extern const Rule unknown_name, ambiguous_kind, not_unique, unknown_import, robosim_unread;
// rules_nodes.cpp
extern const Rule s2, ij1, ij2, fs1, fs2, fs3, j1, j2, j3, t1, t2, pj1, pj2, pj3, pj3_unknown, pt1, pt2, pt2_unknown,
    stm3, stm3_inner, stm4, parameter_assigned;
// rules_components.cpp
extern const Rule stm1, stm6, stm7, stm8, stm8_required, stm9, stm10, rp1, rp2, rp3, o1, i1, i2, i_mixed, c1, c2, c3,
    c4, c4_operation, c7, c8, c9, c10, c11, m1, m_controller, m_machine, m2_variables, m2_operations, dt;
// rules_connections.cpp
extern const Rule cn1, cn2, cn3, cn4, cn4_levels, cn_types, cn10, cn11, c6, m3, cn5, cn6, cn6_direction, cn7,
    cn7_direction, cn8, cn9;
// rules_time.cpp
extern const Rule tt1, te1, te1_elsewhere, te2, te3, te4, te4_type, te5, ts1, untimed;
// rules_types.cpp
extern const Rule initial_type, assignment_type, if_type, condition_type, wait_type, call_count, call_type, tg5, tg2,
    comm_input, comm_value, literal_count, literal_bare, literal_type, function_count, function_type, not_callable,
    tuple_index, index_count, not_indexable, no_field, field_type, field_missing, cast_type, operand_type, unary_type,
    compare_type, mixed_types, size_value, condition_boolean, deadline_type, not_assignable, comm_narrow,
    wrong_contract, range_bounds, index_type, function_bare;

// rules_assertions.cpp
extern const Rule unknown_component, not_a_component, no_state, no_clock, no_constant, constant_type, constant_twice,
    constants_open, part_passed_over, not_a_property, path_property, missed_where;
// rules_lints.cpp
extern const Rule w_loose_machine, w_loose_controller, w_loose_platform, w_stuck, w_unreachable, w_never, w_else_never,
    w_always, w_unset, w_unused, w_unread, w_loop, w_negative, w_zero, w_maybe_zero, w_shadows, w_hidden_member,
    w_endless, w_copy, w_self, w_deadline, w_deaf, w_never_reset, w_broken_promise, w_missed, w_grows;

[[nodiscard]] const std::vector<const Rule*>& of_names();
[[nodiscard]] const std::vector<const Rule*>& of_nodes();
[[nodiscard]] const std::vector<const Rule*>& of_components();
[[nodiscard]] const std::vector<const Rule*>& of_connections();
[[nodiscard]] const std::vector<const Rule*>& of_time();
[[nodiscard]] const std::vector<const Rule*>& of_types();
[[nodiscard]] const std::vector<const Rule*>& of_lints();
[[nodiscard]] const std::vector<const Rule*>& of_assertions();
/// All rules.
[[nodiscard]] std::vector<const Rule*> all();

}  // namespace robochart::frontend::rules
