// Definitions of blocks Instantiations that nothing reads. The script has the generated value where a block leaves one
// out, so a misspelt name would change verdicts silently; FDR, with RoboTool's script, stops at the name that is
// missing.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "csp_emit/block_definitions.hpp"

namespace robochart::csp_emit {

/// Warns (RC-C13) of each definition of a block Instantiations whose name nothing has that is generated or that another
/// definition mentions, if it is named like a carrier or constant, or nearly like a name that the block leaves out.
/// `known`: all that is generated; `left_out`: of these the instantiations that no block defines.
void check_instantiations_read(const Project&, const std::map<std::string, std::vector<BlockDefinition>>&,
                               const std::set<std::string>& known, const std::vector<std::string>& left_out);

}  // namespace robochart::csp_emit
