// SPDX-License-Identifier: Apache-2.0
#include "editors/server/workspace/target.hpp"

#include "editors/server/protocol/uri.hpp"
#include "editors/server/workspace/library_files.hpp"

namespace robochart::lsp {

std::vector<diagnostics::Diagnostic> findings_about(const Target& target) {
    std::vector<diagnostics::Diagnostic> result = target.document.findings.sorted_findings();
    for (const auto* found : {&target.project.current_findings(), &target.project.block_findings()})
        for (diagnostics::Diagnostic& finding : found->sorted_findings())
            if (finding.span.source == target.document.source) result.push_back(std::move(finding));
    return result;
}

Json lsp_location(const Session& session, Project& project, Span span) {
    if (!span.is_known()) return {};
    const SourceManager& sources = project.sources();
    const Document* document = project.find(span.source);
    const std::string library =
        document == nullptr ? library_file(sources.path(span.source), sources.source_text(span.source)) : std::string();
    if (document == nullptr && library.empty()) return {};
    return Json::object({{"uri", document != nullptr ? document->uri : uri_of_path(library)},
                         {"range", lsp_range(sources, span, session.client.encoding)}});
}

}  // namespace robochart::lsp
