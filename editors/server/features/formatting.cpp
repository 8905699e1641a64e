// SPDX-License-Identifier: Apache-2.0
// Formats texts in the standard layout (docs/format.md).
#include "editors/server/documents/text_difference.hpp"
#include "editors/server/features/models.hpp"
#include "frontend/format/format.hpp"

namespace robochart::lsp {

Json Models::formatting(const Request& request) {
    const Target target = target_of(request);
    const SourceManager& sources = target.project.sources();
    const SourceId source = target.document.source;
    diagnostics::Diagnostics ignored;
    return formatting_edits(sources, source, frontend::format(sources, source, target.document.is_assertions, ignored),
                            session_.client.encoding);
}

}  // namespace robochart::lsp
