// SPDX-License-Identifier: Apache-2.0
// Sends the findings of rules to the editor.
#include <map>

#include "editors/server/features/diagram.hpp"
#include "editors/server/features/features.hpp"
#include "editors/server/protocol/findings.hpp"

namespace robochart::lsp {

namespace {

using diagnostics::Diagnostic;

/// The findings of a project, by text.
std::map<SourceId, Json> by_source(const Session& session, Project& project) {
    std::map<SourceId, Json> result;
    const Locate locate = [&](Span span) { return lsp_location(session, project, span); };
    const auto add = [&](const diagnostics::Diagnostics& findings) {
        for (const Diagnostic& finding : findings.sorted_findings())
            if (finding.span.is_known())
                result[finding.span.source].push_back(
                    lsp_diagnostic(project.sources(), finding, session.client.encoding, locate));
    };
    for (const auto& [path, document] : project.documents()) add(document->findings);
    add(project.current_findings());
    add(project.block_findings());
    return result;
}

}  // namespace

Json document_diagnostic(Session& session, View params) {
    const Target target = target_of(session, params);
    std::map<SourceId, Json> found = by_source(session, target.project);
    const auto own = found.find(target.document.source);
    Json items = own != found.end() ? std::move(own->second) : Json::array();
    target.document.pulled = text_of_findings(items);
    return Json::object({{"kind", "full"}, {"items", std::move(items)}});
}

/// If the editor requests the diagnostics of open documents, the server does not send them as well, because the editor
/// would show them twice.
void publish_diagnostics(Session& session) {
    bool refresh = false;
    for (const auto& project : session.workspace.projects()) {
        if (!project->take_news()) continue;
        std::map<SourceId, Json> found = by_source(session, *project);
        for (const auto& [path, document] : project->documents()) {
            Json list = found.contains(document->source) ? std::move(found[document->source]) : Json::array();
            std::string text = text_of_findings(list);
            if (session.client.pulls_diagnostics && document->open) {
                refresh = refresh || text != document->pulled;
                list = Json::array();
                text.clear();
            }
            if (text == document->published) continue;
            document->published = std::move(text);
            session.send(publication_message(document->uri, document->version, std::move(list)));
        }
        announce_diagrams(session, *project);
    }
    if (refresh && session.client.refreshes_diagnostics) session.send(refresh_request(++session.refreshes));
    for (const std::string& uri : session.workspace.take_orphans())
        if (const auto place = session.workspace.find(uri); !place || place.document->published.empty())
            session.send(publication_message(uri, {}, Json::array()));
}

}  // namespace robochart::lsp
