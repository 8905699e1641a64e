// SPDX-License-Identifier: Apache-2.0
#include "editors/server/plain/answers.hpp"

#include <fmt/format.h>

#include "editors/server/protocol/findings.hpp"

namespace robochart::lsp {

namespace {

std::map<std::string, Json> plain_findings(const Session& session, PlainTexts& texts) {
    std::map<std::string, Json> result;
    for (const auto& [uri, document] : texts.all_documents()) {
        const Locate locate = [&, &at = uri, &text = *document](Span span) -> Json {
            if (!span.is_known()) return {};
            return Json::object({{"uri", at}, {"range", lsp_range(text.texts, span, session.client.encoding)}});
        };
        Json& list = result[uri] = Json::array();
        for (const diagnostics::Diagnostic& finding : texts.findings_in(*document).sorted_findings())
            if (finding.span.is_known())
                list.push_back(lsp_diagnostic(document->texts, finding, session.client.encoding, locate));
    }
    return result;
}

Json plain_hover(const Session& session, PlainTexts& texts, PlainText& document, std::uint32_t offset) {
    const bool markdown = session.client.markdown;
    std::string why = explain_findings(texts.findings_in(document).sorted_findings(), offset, markdown);
    return hover_answer(document.texts, std::move(why), {}, session.client.encoding, markdown);
}

Json plain_completion(const Session& session, const PlainTexts& texts, const PlainText& document,
                      std::uint32_t offset) {
    const std::string_view text = document.texts.source_text(document.source);
    const auto in_word = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    std::uint32_t begin = offset;
    while (begin > 0 && in_word(text[begin - 1])) --begin;
    const Json edited = lsp_range(document.texts, {document.source, begin, offset}, session.client.encoding);
    constexpr int keyword = 14;
    Json items = Json::array();
    for (const std::string& word : texts.words_at(document, begin))
        items.push_back(Json::object(
            {{"label", word}, {"kind", keyword}, {"textEdit", Json::object({{"range", edited}, {"newText", word}})}}));
    return Json::object({{"isIncomplete", false}, {"items", std::move(items)}});
}

std::string_view uri_of(View params) {
    return params["textDocument"]["uri"].text();
}

}  // namespace

bool notify_plain(const Session& session, PlainTexts& texts, std::string_view method, View params) {
    const View given = params["textDocument"];
    const std::string& uri = given["uri"].text();
    if (method == "textDocument/didOpen") {
        const std::string& language = given["languageId"].text();
        if (uri.empty() || !is_plain(uri, language)) return false;
        take_opened(params, [&](const std::string& at, std::string text) -> OpenText& {
            return texts.open_document(at, language, std::move(text));
        });
        return true;
    }
    PlainText* const known = texts.find(uri);
    if (known == nullptr) return false;
    if (method == "textDocument/didChange")
        take_changes(*known, params, session.client.encoding,
                     [&](std::string text) { texts.change(*known, std::move(text)); });
    if (method == "textDocument/didClose") texts.close(uri);
    return true;
}

bool asks_for_plain(PlainTexts& texts, View params) {
    return texts.find(uri_of(params)) != nullptr || is_plain(uri_of(params));
}

Json answer_for_plain(const Session& session, PlainTexts& texts, std::string_view method, View params) {
    PlainText* const document = texts.find(uri_of(params));
    if (document == nullptr)
        throw Refusal(ErrorCode::invalid_params, fmt::format("no such document: {}", uri_of(params)));
    const std::uint32_t offset =
        offset_of(document->texts, document->source, params["position"], session.client.encoding);
    if (method == "textDocument/diagnostic") return pulled_findings(*document, plain_findings(session, texts));
    if (method == "textDocument/hover") return plain_hover(session, texts, *document, offset);
    if (method == "textDocument/completion") return plain_completion(session, texts, *document, offset);
    return nullptr;
}

void publish_plain(Session& session, PlainTexts& texts) {
    if (!texts.has_news()) return;
    texts.published.send_findings(session, plain_findings(session, texts),
                                  [&](const std::string& uri) { return texts.find(uri); });
    texts.settle_news();
}

}  // namespace robochart::lsp
