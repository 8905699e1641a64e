// SPDX-License-Identifier: Apache-2.0
// Manages the documents of projects, and reports the findings about them.
#include "editors/server/features/models.hpp"

#include <utility>

#include "editors/server/features/diagram.hpp"
#include "editors/server/protocol/findings.hpp"

namespace robochart::lsp {

Models::Models(Session& session)
    : Language(session), workspace_(session.budget), diagrams_(std::make_unique<KeptDiagrams>()) {}

Models::~Models() = default;

bool Models::accepts(std::string_view /*uri*/, std::string_view /*language_id*/) const {
    return true;
}

TextDocument& Models::open_document(const std::string& uri, std::string text) {
    return *workspace_.open_document(uri, std::move(text)).document;
}

void Models::change(TextDocument& document, std::string text) {
    const Workspace::Place place = workspace_.find(document.uri);
    place.project->change(*place.document, std::move(text));
}

void Models::close(const std::string& uri) {
    workspace_.close(uri);
    documents_left_ = true;
}

void Models::remove_folder(const std::string& path) {
    workspace_.remove_folder(path);
    documents_left_ = true;
}

Target Models::target_of(const Request& request) {
    const Workspace::Place place = workspace_.find(request.document.uri);
    return {*place.project, *place.document, request.offset};
}

std::map<std::string, Json> Models::findings_of(Project& project) const {
    std::map<std::string, Json> result;
    for (const auto& [path, document] : project.documents()) result.emplace(document->uri, Json::array());
    const Locate locate = [&](Span span) { return lsp_location(session_, project, span); };
    const auto add = [&](const diagnostics::Diagnostics& findings) {
        for (const diagnostics::Diagnostic& finding : findings.sorted_findings())
            if (const Document* document = project.find(finding.span.source))
                result[document->uri].push_back(
                    lsp_diagnostic(project.sources(), finding, session_.client.encoding, locate));
    };
    for (const auto& [path, document] : project.documents()) add(document->findings);
    add(project.current_findings());
    add(project.block_findings());
    return result;
}

Json Models::findings_in(TextDocument& document) {
    return findings_of(*workspace_.find(document.uri).project).at(document.uri);
}

void Models::publish() {
    for (const auto& project : workspace_.projects()) {
        if (!project->take_news()) continue;
        send_findings(findings_of(*project));
        announce_diagrams(*project);
    }
    if (std::exchange(documents_left_, false)) send_findings({});
}

}  // namespace robochart::lsp
