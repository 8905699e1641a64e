// SPDX-License-Identifier: Apache-2.0
// The finite carriers, constants and functions: RoboTool's instantiations.csp and *_defs.csp (semantics 3.13).
#pragma once

#include "csp_emit/base/project.hpp"

namespace robochart::csp_emit {

/// Definitions that no CSP block overrides: enumerations, and preconditions of functions.
[[nodiscard]] std::vector<cspm::DeclPtr> data_definitions(const Project&);
/// Definitions that CSP blocks use without declaring them. For a record T these are its carrier `P_T` and two functions
/// for each field f: `P_T_f(x)` returns the field, and `update_P_T_f(x,v)` returns the record with another value of the
/// field.
[[nodiscard]] std::vector<cspm::DeclPtr> record_definitions(const Project&, const std::set<std::string>& declared);
/// Carriers, constants, functions and clipped arithmetic; a CSP block named Instantiations replaces them.
[[nodiscard]] std::vector<cspm::DeclPtr> instantiation_definitions(const Project&);
/// `const_P_S_c`, the machine's own constant; the name of the part's constant if the instantiation gives the part
/// another value.
[[nodiscard]] std::string default_constant(const Project&, const std::string& own, const std::string& part);

}  // namespace robochart::csp_emit
