// SPDX-License-Identifier: Apache-2.0
// Reports the findings about scripts, and answers requests.
#include <fmt/format.h>

#include <algorithm>

#include "editors/server/cspm/places.hpp"
#include "editors/server/cspm/scripts.hpp"
#include "editors/server/cspm/symbols.hpp"
#include "editors/server/protocol/findings.hpp"

namespace robochart::lsp {

namespace {

using diagnostics::Diagnostic;

/// Adds a finding unless the list contains it. A file may be included by several scripts, or several times by one.
void add_new(Json& list, Json finding) {
    if (std::ranges::find(list, finding) == list.end()) list.push_back(std::move(finding));
}

}  // namespace

Json Scripts::script_location(const ScriptReading& reading, Span span) const {
    if (!span.is_known()) return {};
    return Json::object(
        {{"uri", uri_of(reading, span.source)}, {"range", lsp_range(reading.sources, span, session_.client.encoding)}});
}

/// Returns all findings, including those about files that scripts include.
std::map<std::string, Json> Scripts::all_findings() {
    std::map<std::string, Json> result;
    for (const auto& [uri, document] : documents()) result.emplace(uri, Json::array());
    for (const ScriptReading* reading : current_readings()) {
        const Locate locate = [&](Span span) { return script_location(*reading, span); };
        for (const Diagnostic& finding : reading->findings.sorted_findings())
            if (finding.span.is_known())
                add_new(result[uri_of(*reading, finding.span.source)],
                        lsp_diagnostic(reading->sources, finding, session_.client.encoding, locate));
    }
    return result;
}

Json Scripts::findings_in(TextDocument& document) {
    return all_findings().at(document.uri);
}

Json Scripts::hover(const Request& request) {
    const ScriptDocument& document = text_of(request.document);
    const ScriptReading& reading = reading_of(document);
    const SourceId source = reading.at.at(document.file);
    Hover hover;
    if (const std::optional<NameAt> name = name_at(reading, source, request.offset)) {
        hover.place = {document.source, name->span.begin, name->span.end};
        if (!name->known->type.empty())
            hover.text = fmt::format(fmt::runtime(session_.client.markdown ? "```cspm\n{} :: {}\n```" : "{} :: {}"),
                                     name->known->name, name->known->type);
    }
    std::vector<Diagnostic> findings = reading.findings.sorted_findings();
    std::erase_if(findings, [&](const Diagnostic& finding) { return finding.span.source != source; });
    return hover_answer(request, std::move(hover), findings);
}

Json Scripts::definition(const Request& request) {
    const ScriptDocument& document = text_of(request.document);
    const ScriptReading& reading = reading_of(document);
    const std::optional<NameAt> name = name_at(reading, reading.at.at(document.file), request.offset);
    if (!name || !name->known->span.is_known()) return {};
    const Span place = name_place(reading.sources, name->known->span, name->known->name);
    return Json::array({script_location(reading, place)});
}

Json Scripts::document_symbols(const Request& request) {
    const ScriptDocument& document = text_of(request.document);
    const ScriptReading& reading = reading_of(document);
    return script_symbols(reading, reading.at.at(document.file), document.uri, session_.client.encoding,
                          session_.client.hierarchical_symbols);
}

}  // namespace robochart::lsp
