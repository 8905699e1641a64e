// SPDX-License-Identifier: Apache-2.0
// Defines the finite carriers, constants and functions, as in RoboTool's instantiations.csp and *_defs.csp (semantics
// 3.13).
#pragma once

#include "csp_emit/base/project.hpp"

namespace robochart::csp_emit {

/// Returns the definitions that no CSP block overrides: enumerations, and preconditions of functions.
[[nodiscard]] std::vector<cspm::DeclPtr> data_definitions(const Project&);
/// Returns definitions that CSP blocks use but do not declare. For a record T, these are its carrier `P_T` and two
/// functions for each field f: `P_T_f(x)` returns the field, and `update_P_T_f(x,v)` returns the record with v as this
/// field.
[[nodiscard]] std::vector<cspm::DeclPtr> record_definitions(const Project&, const std::set<std::string>& declared);
/// Returns the definitions that a CSP block named Instantiations replaces: carriers, constants, functions and clipped
/// arithmetic.
[[nodiscard]] std::vector<cspm::DeclPtr> instantiation_definitions(const Project&);
/// Returns the name of the machine's own constant, `const_P_S_c`. Returns the name of the part's constant if the
/// instantiation gives the part another value.
[[nodiscard]] std::string default_constant(const Project&, const std::string& own, const std::string& part);

}  // namespace robochart::csp_emit
