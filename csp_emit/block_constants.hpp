// SPDX-License-Identifier: Apache-2.0
// One constant has several names in a block Instantiations: the machine's own (`const_P_S_c`) and one for each place in
// which a controller runs the machine (`const_P_C_ref_c`). In every claim about a controller or a module, RoboTool sets
// the second to the first, so the machine's own name decides if a block defines it.
#pragma once

#include <set>
#include <string>

#include "csp_emit/block_definitions.hpp"

namespace robochart::csp_emit {

/// Reports which name decides if a block gives different values to a machine's own constant and to a part's (RC-C17).
/// Rejects blocks that give two parts different values and the machine's own constant none (RC-C18), because RoboTool's
/// scripts have a single constant there. Returns the constants of parts that a block defines and that do not count.
std::set<std::string> check_names_of_constants(const Project&,
                                               const std::map<std::string, std::vector<BlockDefinition>>&);

}  // namespace robochart::csp_emit
