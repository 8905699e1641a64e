// SPDX-License-Identifier: Apache-2.0
// See block_definitions.hpp.
#include "csp_emit/block_definitions.hpp"

#include <algorithm>

#include "csp_emit/base/user_names.hpp"

namespace robochart::csp_emit {
namespace {

/// Returns the place in the user's file. (Blocks are parsed from copies.)
diagnostics::Span in_file(const Project& project, const std::string& file, diagnostics::Span span) {
    const auto& blocks = project.system.csp_blocks;
    const auto block = std::ranges::find_if(blocks, [&](const ir::CspBlock& candidate) {
        return candidate.file == file && candidate.text_span.is_known();
    });
    if (block != blocks.end()) span.source = block->text_span.source;
    return span;
}

}  // namespace

std::map<std::string, std::vector<BlockDefinition>> block_definitions(const Project& project,
                                                                      const std::vector<FileBlocks>& files,
                                                                      const NamesForBlocks& of_model) {
    std::map<std::string, std::vector<BlockDefinition>> result;
    for (const FileBlocks& file : files)
        for (const cspm::DeclPtr& decl : file.instantiations)
            for (const std::string& name : user_names({decl}).all) {
                const auto changed = of_model.data.find(name);
                result[changed == of_model.data.end() ? name : changed->second].push_back(
                    {decl, in_file(project, file.file, decl->span)});
            }
    return result;
}

}  // namespace robochart::csp_emit
