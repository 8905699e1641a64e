// SPDX-License-Identifier: Apache-2.0
// Checks CSP blocks named Instantiations that give more than one value to a constant. Such a block may name a constant
// in several ways: `const_P_S_c` for the machine's own constant, and `const_P_C_ref_c` for each reference of a
// controller to the machine. In every claim about a controller or a module, RoboTool sets the constant of the reference
// to the machine's own constant. So if the block defines the machine's own constant, this definition determines the
// value.
#pragma once

#include <set>
#include <string>

#include "csp_emit/block_definitions.hpp"

namespace robochart::csp_emit {

/// Reports a block that gives a machine's own constant and the constant of a part different values (RC-C17); the
/// message says which name determines the value. Rejects a block that gives two parts different values without defining
/// the machine's own constant (RC-C18): RoboTool's scripts have only one constant for both. Returns the constants of
/// parts that a block defines without effect.
std::set<std::string> check_names_of_constants(const Project&,
                                               const std::map<std::string, std::vector<BlockDefinition>>&);

}  // namespace robochart::csp_emit
