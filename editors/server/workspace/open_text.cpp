// SPDX-License-Identifier: Apache-2.0
#include "editors/server/workspace/open_text.hpp"

#include <utility>

#include "editors/server/protocol/findings.hpp"

namespace robochart::lsp {

void take_opened(View params, const std::function<OpenText&(const std::string& uri, std::string text)>& open) {
    const View given = params["textDocument"];
    OpenText& document = open(given["uri"].text(), given["text"].text());
    if (given["version"].is_number()) document.version = given["version"].number_or();
}

void take_changes(OpenText& document, View params, Encoding encoding,
                  const std::function<void(std::string text)>& change) {
    for (const View edit : params["contentChanges"].items()) {
        if (!edit["text"].is_text()) continue;
        std::string text = edit["text"].text();
        if (edit.has_key("range")) {
            const Span span = span_of(document.texts, document.source, edit["range"], encoding);
            text = std::string(document.texts.source_text(document.source))
                       .replace(span.begin, span.end - span.begin, text);
        }
        change(std::move(text));
    }
    const View version = params["textDocument"]["version"];
    if (version.is_number()) document.version = version.number_or();
}

Json pulled_findings(OpenText& document, const std::map<std::string, Json>& found) {
    const auto own = found.find(document.uri);
    Json items = own != found.end() ? own->second : Json::array();
    document.pulled = text_of_findings(items);
    return Json::object({{"kind", "full"}, {"items", std::move(items)}});
}

void Published::send_findings(Session& session, std::map<std::string, Json> found,
                              const std::function<const OpenText*(const std::string& uri)>& opened) {
    for (const auto& [uri, text] : sent_) found.emplace(uri, Json::array());
    bool refresh = false;
    for (auto& [uri, list] : found) {
        const OpenText* const document = opened(uri);
        std::string text = text_of_findings(list);
        if (session.client.pulls_diagnostics && document != nullptr) {
            refresh = refresh || text != document->pulled;
            list = Json::array();
            text.clear();
        }
        std::string& before = sent_[uri];
        if (text == before) continue;
        before = std::move(text);
        session.send(publication_message(uri, document != nullptr ? document->version : std::nullopt, std::move(list)));
    }
    std::erase_if(sent_, [](const auto& entry) { return entry.second.empty(); });
    if (refresh && session.client.refreshes_diagnostics) session.send(refresh_request(++session.refreshes));
}

}  // namespace robochart::lsp
