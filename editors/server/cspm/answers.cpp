// SPDX-License-Identifier: Apache-2.0
#include "editors/server/cspm/answers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "editors/server/cspm/places.hpp"
#include "editors/server/cspm/symbols.hpp"
#include "editors/server/protocol/findings.hpp"

namespace robochart::lsp {

namespace {

using diagnostics::Diagnostic;

std::string_view uri_in(View params) {
    const View uri = params["textDocument"]["uri"];
    return uri.is_text() ? uri.text() : params["item"]["uri"].text();
}

// ---------------------------------------------------------------- findings

Json script_location(const Session& session, const Scripts& scripts, const ScriptReading& reading, Span span) {
    if (!span.is_known()) return {};
    return Json::object({{"uri", scripts.uri_of(reading, span.source)},
                         {"range", lsp_range(reading.sources, span, session.client.encoding)}});
}

/// Adds a finding unless the list contains it. A file may be included by several scripts, or several times by one.
void add_new(Json& list, Json finding) {
    if (std::ranges::find(list, finding) == list.end()) list.push_back(std::move(finding));
}

/// The findings of all scripts by URI; every open document has a list, which may be empty.
std::map<std::string, Json> script_findings(const Session& session, Scripts& scripts) {
    std::map<std::string, Json> result;
    for (const ScriptReading* reading : scripts.current_readings()) {
        const Locate locate = [&](Span span) { return script_location(session, scripts, *reading, span); };
        for (const auto& [source, file] : reading->in) result.emplace(scripts.uri_of(*reading, source), Json::array());
        for (const Diagnostic& finding : reading->findings.sorted_findings())
            if (finding.span.is_known())
                add_new(result[scripts.uri_of(*reading, finding.span.source)],
                        lsp_diagnostic(reading->sources, finding, session.client.encoding, locate));
    }
    return result;
}

// ---------------------------------------------------------------- names

/// The place in a script that a request is about.
struct ScriptPlace {
    const ScriptReading& reading;
    SourceId source;
    std::uint32_t offset;
};

ScriptPlace place_in(const Session& session, Scripts& scripts, const ScriptDocument& document, View params) {
    const ScriptReading& reading = scripts.reading_of(document);
    const SourceId source = reading.at.at(document.file);
    return {reading, source, offset_of(reading.sources, source, params["position"], session.client.encoding)};
}

Json script_hover(const Session& session, Scripts& scripts, ScriptDocument& document, View params) {
    const ScriptPlace at = place_in(session, scripts, document, params);
    const bool markdown = session.client.markdown;
    const std::optional<NameAt> name = name_at(at.reading, at.source, at.offset);
    std::string text;
    if (name && !name->known->type.empty())
        text = fmt::format(fmt::runtime(markdown ? "```cspm\n{} :: {}\n```" : "{} :: {}"), name->known->name,
                           name->known->type);
    std::vector<Diagnostic> findings = at.reading.findings.sorted_findings();
    std::erase_if(findings, [&](const Diagnostic& finding) { return finding.span.source != at.source; });
    const std::string rules = explain_findings(findings, at.offset, markdown);
    if (!text.empty() && !rules.empty()) text += markdown ? "\n\n---\n" : "\n\n";
    text += rules;
    return hover_answer(at.reading.sources, std::move(text), name ? name->span : Span(), session.client.encoding,
                        markdown);
}

Json script_definition(const Session& session, Scripts& scripts, ScriptDocument& document, View params) {
    const ScriptPlace at = place_in(session, scripts, document, params);
    const std::optional<NameAt> name = name_at(at.reading, at.source, at.offset);
    if (!name || !name->known->span.is_known()) return {};
    const Span place = name_place(at.reading.sources, name->known->span, name->known->name);
    return Json::array({script_location(session, scripts, at.reading, place)});
}

Json script_outline(const Session& session, Scripts& scripts, ScriptDocument& document) {
    const ScriptReading& reading = scripts.reading_of(document);
    return script_symbols(reading, reading.at.at(document.file), document.uri, session.client.encoding,
                          session.client.hierarchical_symbols);
}

}  // namespace

bool notify_script(const Session& session, Scripts& scripts, std::string_view method, View params) {
    if (method == "workspace/didChangeWatchedFiles") {
        for (const View change : params["changes"].items())
            if (is_script(change["uri"].text())) scripts.refresh_file(change["uri"].text());
        return false;
    }
    const View document = params["textDocument"];
    const std::string& uri = document["uri"].text();
    ScriptDocument* const known = scripts.find(uri);
    if (method == "textDocument/didOpen") {
        if (uri.empty() || !is_script(uri, document["languageId"].text())) return false;
        take_opened(params, [&](const std::string& at, std::string text) -> OpenText& {
            return scripts.open_document(at, std::move(text));
        });
        return true;
    }
    if (known == nullptr) return false;
    if (method == "textDocument/didChange")
        take_changes(*known, params, session.client.encoding,
                     [&](std::string text) { scripts.change(*known, std::move(text)); });
    if (method == "textDocument/didClose") scripts.close(uri);
    return true;
}

bool asks_for_script(Scripts& scripts, View params) {
    const std::string_view uri = uri_in(params);
    return scripts.find(uri) != nullptr || is_script(uri);
}

Json answer_for_script(const Session& session, Scripts& scripts, std::string_view method, View params) {
    const std::string_view uri = uri_in(params);
    ScriptDocument* const document = scripts.find(uri);
    if (document == nullptr) throw Refusal(ErrorCode::invalid_params, fmt::format("no such document: {}", uri));
    if (method == "textDocument/diagnostic") return pulled_findings(*document, script_findings(session, scripts));
    if (method == "textDocument/documentSymbol") return script_outline(session, scripts, *document);
    if (method == "textDocument/hover") return script_hover(session, scripts, *document, params);
    if (method == "textDocument/definition" || method == "textDocument/declaration")
        return script_definition(session, scripts, *document, params);
    return nullptr;
}

void publish_scripts(Session& session, Scripts& scripts) {
    if (!scripts.has_news()) return;
    scripts.published.send_findings(session, script_findings(session, scripts),
                                    [&](const std::string& uri) { return scripts.find(uri); });
    scripts.settle_news();
}

}  // namespace robochart::lsp
