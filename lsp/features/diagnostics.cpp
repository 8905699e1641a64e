// Findings of the rules as an editor shows them.
#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "diagnostics/fixes.hpp"
#include "lsp/features/features.hpp"

namespace robochart::lsp {

namespace {

using diagnostics::Diagnostic;
using diagnostics::Severity;

int severity_number(Severity severity) {
    return severity == Severity::error ? 1 : severity == Severity::warning ? 2 : 3;
}

/// LSP wants a place with every related message; notes without one become part of the message.
std::string message_of(const Diagnostic& finding) {
    std::string text = finding.message();
    for (const diagnostics::Note& note : finding.notes)
        if (!note.span.known()) text += "\n" + note.message;
    for (const diagnostics::FixIt& fix : finding.fixes)
        if (!fix.replacement.empty())
            text += "\n" + fix.title + " `" + fix.replacement + (diagnostics::is_certain(fix) ? "`" : "`?");
    return text;
}

constexpr int unnecessary_tag = 1;  // DiagnosticTag.Unnecessary

/// Warnings about what could as well be left out: never reached, taken, used or read, a copy (rules RC-W…).
bool is_unneeded(std::string_view code) {
    constexpr std::array<std::string_view, 5> codes = {"RC-W03", "RC-W04", "RC-W07", "RC-W08", "RC-W14"};
    return std::find(codes.begin(), codes.end(), code) != codes.end();
}

Json related(const Session& session, Project& project, const Diagnostic& finding) {
    Json list = Json::array();
    for (const diagnostics::Note& note : finding.notes) {
        Json place = location(session, project, note.span);
        if (!place.is_null()) list.push_back(Json::object({{"location", std::move(place)}, {"message", note.message}}));
    }
    return list;
}

Json diagnostic(const Session& session, Project& project, const Diagnostic& finding) {
    Json result = Json::object({{"range", range(project.sources(), finding.span, session.client.encoding)},
                                {"severity", severity_number(finding.rule->severity)},
                                {"code", finding.rule->code},
                                {"source", "robochart"},
                                {"message", message_of(finding)}});
    Json notes = related(session, project, finding);
    if (!notes.empty()) result["relatedInformation"] = std::move(notes);
    if (is_unneeded(finding.rule->code)) result["tags"] = Json::array({unnecessary_tag});
    return result;
}

/// The findings of a project, by the text that they are about.
std::map<SourceId, Json> by_source(const Session& session, Project& project) {
    std::map<SourceId, Json> result;
    const auto add = [&](const diagnostics::Diagnostics& findings) {
        for (const Diagnostic& finding : findings.sorted())
            if (finding.span.known()) result[finding.span.source].push_back(diagnostic(session, project, finding));
    };
    for (const auto& [path, document] : project.documents()) add(document->findings);
    add(project.findings());
    return result;
}

void send(Session& session, const std::string& uri, std::optional<std::int64_t> version, Json list) {
    Json params = Json::object({{"uri", uri}, {"diagnostics", std::move(list)}});
    if (version) params["version"] = *version;
    session.send(Json::object(
        {{"jsonrpc", "2.0"}, {"method", "textDocument/publishDiagnostics"}, {"params", std::move(params)}}));
}

/// What an editor that asks was answered last is no longer true: it is to ask again.
void send_refresh(Session& session) {
    session.send(Json::object({{"jsonrpc", "2.0"},
                               {"id", "refresh-diagnostics-" + std::to_string(++session.refreshes)},
                               {"method", "workspace/diagnostic/refresh"}}));
}

std::string text_of(const Json& list) {
    return list.empty() ? std::string() : json_text(list);
}

}  // namespace

Json document_diagnostic(Session& session, View params) {
    const Target target = target_of(session, params);
    std::map<SourceId, Json> found = by_source(session, target.project);
    const auto own = found.find(target.document.source);
    Json items = own != found.end() ? std::move(own->second) : Json::array();
    target.document.pulled = text_of(items);
    return Json::object({{"kind", "full"}, {"items", std::move(items)}});
}

/// Of open documents nothing is pushed to an editor that asks for their diagnostics: it would show them twice.
void publish(Session& session) {
    bool refresh = false;
    for (const auto& project : session.workspace.projects()) {
        if (!project->take_news()) continue;
        std::map<SourceId, Json> found = by_source(session, *project);
        for (const auto& [path, document] : project->documents()) {
            Json list = found.contains(document->source) ? std::move(found[document->source]) : Json::array();
            std::string text = text_of(list);
            if (session.client.pulls_diagnostics && document->open) {
                refresh = refresh || text != document->pulled;
                list = Json::array();
                text.clear();
            }
            if (text == document->published) continue;
            document->published = std::move(text);
            send(session, document->uri, document->version, std::move(list));
        }
    }
    if (refresh && session.client.refreshes_diagnostics) send_refresh(session);
    for (const std::string& uri : session.workspace.take_orphans())
        if (const auto place = session.workspace.find(uri); !place || place.document->published.empty())
            send(session, uri, {}, Json::array());
}

}  // namespace robochart::lsp
