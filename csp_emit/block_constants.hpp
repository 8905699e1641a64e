// One constant has several names in a block Instantiations: the machine's own (`const_P_S_c`) and one for each place in
// which a controller runs the machine (`const_P_C_ref_c`). In every claim about a controller or a module RoboTool binds
// the second to the first, so the machine's own name decides where a block defines it.
#pragma once

#include <set>
#include <string>

#include "csp_emit/block_definitions.hpp"

namespace robochart::csp_emit {

/// Says which name decides where a block gives a machine's own constant and a part's different values (RC-C17), and
/// refuses blocks that give two parts different values and the machine's own constant none (RC-C18): RoboTool's scripts
/// have one constant there. Returns the constants of parts that a block defines and that do not count.
std::set<std::string> check_names_of_constants(const Project&,
                                               const std::map<std::string, std::vector<BlockDefinition>>&);

}  // namespace robochart::csp_emit
