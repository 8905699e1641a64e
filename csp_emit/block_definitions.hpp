// SPDX-License-Identifier: Apache-2.0
// Finds the definitions in blocks Instantiations, with their places in the users' files.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "csp_emit/base/project.hpp"
#include "csp_emit/passes/name_clashes.hpp"

namespace robochart::csp_emit {

struct BlockDefinition {
    cspm::DeclPtr decl;
    diagnostics::Span place;
};

/// Returns the definitions, by the name that the element has in the script. A function has several clauses.
[[nodiscard]] std::map<std::string, std::vector<BlockDefinition>> block_definitions(
    const Project&, const std::vector<FileBlocks>& files, const NamesForBlocks& of_model);

}  // namespace robochart::csp_emit
