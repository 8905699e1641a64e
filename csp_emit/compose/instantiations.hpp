// Finite carriers, constants, functions: RoboTool's instantiations.csp and *_defs.csp (semantics 3.13).
#pragma once

#include "csp_emit/base/project.hpp"

namespace robochart::csp_emit {

/// Enumerations and preconditions of functions: these a user does not override.
[[nodiscard]] std::vector<cspm::DeclPtr> data_definitions(const Project&);
/// What csp blocks name and none declares: of a record T its carrier `P_T`, and for each of its fields `P_T_f(x)` and
/// `update_P_T_f(x,v)`, the record with another value of the field.
[[nodiscard]] std::vector<cspm::DeclPtr> record_definitions(const Project&, const std::set<std::string>& declared);
/// Carriers, constants, functions, clipped arithmetic: replaced by a csp block named Instantiations.
[[nodiscard]] std::vector<cspm::DeclPtr> instantiations(const Project&);
/// `const_P_S_c` of the constant's own declaration, or of the part if the instantiation gives the part another value.
[[nodiscard]] std::string default_constant(const Project&, const std::string& own, const std::string& part);

}  // namespace robochart::csp_emit
