// SPDX-License-Identifier: Apache-2.0
// Formatting in the standard layout (docs/format.md).
#include "editors/server/documents/text_difference.hpp"
#include "editors/server/features/models.hpp"
#include "frontend/format/format.hpp"

namespace robochart::lsp {

/// A text with syntax errors is not changed; its diagnostics give the reason.
Json Models::formatting(const Request& request) {
    const Target target = target_of(request);
    const SourceManager& sources = target.project.sources();
    const SourceId source = target.document.source;
    diagnostics::Diagnostics ignored;
    const auto formatted = frontend::format(sources, source, target.document.is_assertions, ignored);
    if (!formatted) throw Refusal(ErrorCode::request_failed, "not formatted: the text has syntax errors");
    return text_edits(sources, source, *formatted, session_.client.encoding);
}

}  // namespace robochart::lsp
