// SPDX-License-Identifier: Apache-2.0
#include "editors/server/workspace/session.hpp"

#include <fmt/format.h>

#include "editors/server/protocol/uri.hpp"
#include "editors/server/workspace/library_files.hpp"

namespace robochart::lsp {

Target target_of(Session& session, View params) {
    const View uri = params["textDocument"]["uri"];
    if (!uri.is_text()) throw Refusal(ErrorCode::invalid_params, "textDocument.uri is missing");
    const Workspace::Place place = session.workspace.find(uri.text());
    if (!place) throw Refusal(ErrorCode::invalid_params, fmt::format("no such document: {}", uri.text()));
    const View at = params["position"];
    const std::uint32_t offset =
        at.is_null() ? 0 : offset_of(place.project->sources(), place.document->source, at, session.client.encoding);
    return {*place.project, *place.document, offset};
}

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
