// SPDX-License-Identifier: Apache-2.0
// Reports the findings about scenarios, mappings and swarms, and answers requests.
#include "editors/server/plain/plain_texts.hpp"

namespace robochart::lsp {

Json PlainTexts::findings_in(TextDocument& document) {
    return list_findings(document, diagnostics_of(document));
}

Json PlainTexts::hover(const Request& request) {
    return hover_answer(request, {}, diagnostics_of(request.document).sorted_findings());
}

Json PlainTexts::completion(const Request& request) {
    const TextDocument& document = request.document;
    const std::string_view text = document.sources.source_text(document.source);
    const auto in_word = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    std::uint32_t begin = request.offset;
    while (begin > 0 && in_word(text[begin - 1])) --begin;
    const Json edited = lsp_range(document.sources, {document.source, begin, request.offset}, session_.client.encoding);
    constexpr int keyword = 14;
    Json items = Json::array();
    for (const std::string& word : words_at(document, begin))
        items.push_back(Json::object(
            {{"label", word}, {"kind", keyword}, {"textEdit", Json::object({{"range", edited}, {"newText", word}})}}));
    return Json::object({{"isIncomplete", false}, {"items", std::move(items)}});
}

}  // namespace robochart::lsp
