// SPDX-License-Identifier: Apache-2.0
// Finds definitions in blocks Instantiations that nothing reads. The script contains the generated value if a block
// leaves one out, so a misspelt name would silently change verdicts. With RoboTool's script, FDR stops at the missing
// name.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "csp_emit/block_definitions.hpp"

namespace robochart::csp_emit {

/// Warns (RC-C13) of each definition of a block Instantiations whose name is neither generated nor mentioned by another
/// definition, if it has the form of a carrier's or constant's name, or resembles a name that the block leaves out.
/// `known`: all generated names; `left_out`: those of them that are instantiations and that no block defines.
void check_instantiations_read(const Project&, const std::map<std::string, std::vector<BlockDefinition>>&,
                               const std::set<std::string>& known, const std::vector<std::string>& left_out);

}  // namespace robochart::csp_emit
