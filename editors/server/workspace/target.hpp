// SPDX-License-Identifier: Apache-2.0
// The place in a project that a request is about.
#pragma once

#include <vector>

#include "editors/server/workspace/workspace.hpp"

namespace robochart::lsp {

/// The place in a document that a request is about.
struct Target {
    Project& project;
    Document& document;
    std::uint32_t offset = 0;
};

/// The findings about the target's document, sorted by place; parse errors come first.
[[nodiscard]] std::vector<diagnostics::Diagnostic> findings_about(const Target&);
/// `{uri, range}` of a span of the project; null if it is in no file.
[[nodiscard]] Json lsp_location(const Session&, Project&, Span);

}  // namespace robochart::lsp
