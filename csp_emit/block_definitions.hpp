// What blocks Instantiations define, with the places in the files that users wrote.
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

/// By name, under the names that the model's elements have in the script; a function has several clauses.
[[nodiscard]] std::map<std::string, std::vector<BlockDefinition>> block_definitions(
    const Project&, const std::vector<FileBlocks>& files, const NamesForBlocks& of_model);

}  // namespace robochart::csp_emit
