// SPDX-License-Identifier: Apache-2.0
// Describes the place in a project that a request is about.
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

/// Returns the findings about the target's document: parse errors, then other findings, then findings about CSP blocks,
/// each sorted by place.
[[nodiscard]] std::vector<diagnostics::Diagnostic> findings_about(const Target&);
/// Returns `{uri, range}` of a span of the project; null if the span is in no file.
[[nodiscard]] Json lsp_location(const Session&, Project&, Span);

}  // namespace robochart::lsp
