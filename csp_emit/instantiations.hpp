// Finite carriers, constants, functions: RoboTool's instantiations.csp and *_defs.csp (semantics 3.13).
#pragma once

#include "csp_emit/project.hpp"

namespace robochart::csp_emit {

/// Enumerations and preconditions of functions: these a user does not override.
[[nodiscard]] std::vector<cspm::DeclPtr> data_definitions(const Project&);
/// Carriers, constants, functions, clipped arithmetic: replaced by a csp block named Instantiations.
[[nodiscard]] std::vector<cspm::DeclPtr> instantiations(const Project&);
/// `const_P_S_c` of the constant's own declaration, or of the part if the instantiation gives the part another value.
[[nodiscard]] std::string default_constant(const Project&, const std::string& own, const std::string& part);

}  // namespace robochart::csp_emit
