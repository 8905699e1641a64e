// SPDX-License-Identifier: Apache-2.0
#include "editors/server/documents/language.hpp"

#include <fmt/format.h>

#include "editors/server/protocol/findings.hpp"

namespace robochart::lsp {

namespace {

void take_version(TextDocument& document, View params) {
    const View version = params["textDocument"]["version"];
    if (version.is_number()) document.version = version.number_or();
}

}  // namespace

void Language::did_open(View params) {
    const View item = params["textDocument"];
    if (item["uri"].text().empty()) return;
    TextDocument& document = open_document(item["uri"].text(), item["text"].text());
    document.language_id = item["languageId"].text();
    take_version(document, params);
}

void Language::did_change(View params) {
    TextDocument& document = request_of(params).document;
    for (const View edit : params["contentChanges"].items()) {
        if (!edit["text"].is_text()) continue;
        std::string text = edit["text"].text();
        if (edit.has_key("range")) {
            const Span span = span_of(document.sources, document.source, edit["range"], session_.client.encoding);
            text = std::string(document.sources.source_text(document.source))
                       .replace(span.begin, span.end - span.begin, text);
        }
        change(document, std::move(text));
    }
    take_version(document, params);
}

void Language::did_close(View params) {
    close(params["textDocument"]["uri"].text());
}

Request Language::request_of(View params) {
    const View item = params["item"];
    const bool by_item = params["textDocument"].is_null() && item.is_object();
    const View uri = by_item ? item["uri"] : params["textDocument"]["uri"];
    if (!uri.is_text()) throw Refusal(ErrorCode::invalid_params, "textDocument.uri is missing");
    TextDocument* const document = find(uri.text());
    if (document == nullptr) throw Refusal(ErrorCode::invalid_params, fmt::format("no such document: {}", uri.text()));
    const View position = by_item ? item["selectionRange"]["start"] : params["position"];
    return {*document, offset_of(document->sources, document->source, position, session_.client.encoding), params};
}

Json Language::pull_findings(const Request& request) {
    Json items = findings_in(request.document);
    request.document.pulled = text_of_findings(items);
    return Json::object({{"kind", "full"}, {"items", std::move(items)}});
}

Json Language::location_in(const TextDocument& document, Span span) const {
    if (!span.is_known()) return {};
    return Json::object(
        {{"uri", document.uri}, {"range", lsp_range(document.sources, span, session_.client.encoding)}});
}

Json Language::list_findings(const TextDocument& document, const diagnostics::Diagnostics& findings) const {
    const Locate locate = [&](Span span) { return location_in(document, span); };
    Json list = Json::array();
    for (const diagnostics::Diagnostic& finding : findings.sorted_findings())
        if (finding.span.is_known())
            list.push_back(lsp_diagnostic(document.sources, finding, session_.client.encoding, locate));
    return list;
}

Json Language::hover_answer(const Request& request, Hover hover,
                            const std::vector<diagnostics::Diagnostic>& findings) const {
    const bool markdown = session_.client.markdown;
    const std::string rules = explain_findings(findings, request.offset, markdown);
    if (!hover.text.empty() && !rules.empty()) hover.text += markdown ? "\n\n---\n" : "\n\n";
    hover.text += rules;
    if (hover.text.empty()) return {};
    const Json contents =
        Json::object({{"kind", markdown ? "markdown" : "plaintext"}, {"value", std::move(hover.text)}});
    Json result = Json::object({{"contents", contents}});
    if (hover.place.is_known())
        result["range"] = lsp_range(request.document.sources, hover.place, session_.client.encoding);
    return result;
}

void Language::send_findings(std::map<std::string, Json> found) {
    for (const auto& [uri, text] : sent_) {
        const TextDocument* const document = find(uri);
        // The editor may now write the URI of a document differently.
        if (document == nullptr || document->uri != uri) found.emplace(uri, Json::array());
    }
    bool refresh = false;
    for (auto& [uri, list] : found) {
        const TextDocument* const document = find(uri);
        std::string text = text_of_findings(list);
        if (session_.client.pulls_diagnostics && document != nullptr && document->open) {
            refresh = refresh || text != document->pulled;
            list = Json::array();
            text.clear();
        }
        std::string& before = sent_[uri];
        if (text == before) continue;
        before = std::move(text);
        const std::optional<std::int64_t> version = document != nullptr ? document->version : std::nullopt;
        session_.send(publication_message(uri, version, std::move(list)));
    }
    std::erase_if(sent_, [](const auto& entry) { return entry.second.empty(); });
    if (refresh && session_.client.refreshes_diagnostics) session_.send(refresh_request(++session_.refreshes));
}

}  // namespace robochart::lsp
