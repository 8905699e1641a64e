// SPDX-License-Identifier: Apache-2.0
// Finds definitions in blocks Instantiations that no other definition reads. If a block does not define a name, the
// script contains the generated value, so a misspelt name would silently change verdicts. If FDR reads RoboTool's
// script, it stops at the missing name.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "csp_emit/block_definitions.hpp"

namespace robochart::csp_emit {

/// Warns (RC-C13) of a definition in a block Instantiations if its name is neither generated nor mentioned by another
/// definition. The name must have the form of a carrier's or constant's name, or resemble a name that the block does
/// not define. `known` contains all generated names. `left_out` contains the instantiations among these names that no
/// block defines.
void check_instantiations_read(const Project&, const std::map<std::string, std::vector<BlockDefinition>>&,
                               const std::set<std::string>& known, const std::vector<std::string>& left_out);

}  // namespace robochart::csp_emit
