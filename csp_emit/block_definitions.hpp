// SPDX-License-Identifier: Apache-2.0
// The definitions in blocks Instantiations, with their places in the users' files.
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

/// By name in the script of the model's elements; a function has several clauses.
[[nodiscard]] std::map<std::string, std::vector<BlockDefinition>> block_definitions(
    const Project&, const std::vector<FileBlocks>& files, const NamesForBlocks& of_model);

}  // namespace robochart::csp_emit
