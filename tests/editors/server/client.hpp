// SPDX-License-Identifier: Apache-2.0
// Simulates an editor in the same process as the server.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "editors/server/protocol/uri.hpp"
#include "editors/server/server.hpp"
#include "tests/editors/server/answer.hpp"

namespace robochart::lsp::testing {

/// Returns the capabilities of an editor such as VS Code.
inline Json usual_capabilities() {
    const Json yes = true;
    return Json::object(
        {{"general", Json::object({{"positionEncodings", Json::array({"utf-16"})}})},
         {"workspace", Json::object({{"workspaceEdit", Json::object({{"documentChanges", false}})}})},
         {"textDocument",
          Json::object(
              {{"hover", Json::object({{"contentFormat", Json::array({"markdown", "plaintext"})}})},
               {"documentSymbol", Json::object({{"hierarchicalDocumentSymbolSupport", yes}})},
               {"completion", Json::object({{"completionItem", Json::object({{"snippetSupport", yes}})}})}})}});
}

class Client {
public:
    explicit Client(Json capabilities = usual_capabilities(), const std::string& folder = {}, Json options = nullptr)
        : server_([this](const std::string& text) { sent(text); }) {
        Json folders;
        if (!folder.empty()) folders = Json::array({Json::object({{"uri", uri_of_path(folder)}, {"name", "project"}})});
        initialized_ = request("initialize", Json::object({{"processId", nullptr},
                                                           {"capabilities", std::move(capabilities)},
                                                           {"initializationOptions", std::move(options)},
                                                           {"workspaceFolders", folders}}));
        notify("initialized", Json::object({}));
    }

    /// Sends a request and returns the whole response.
    Answer ask(const std::string& method, Json params) {
        const std::int64_t id = ++last_id_;
        server_.receive_message(json_text(
            Json::object({{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", std::move(params)}})));
        work();
        for (const Answer& message : messages)
            if (message["id"] == Answer(id) && !message.has("method")) return message;
        ADD_FAILURE() << method << " was not answered";
        return {};
    }
    /// Sends a request and returns the result. An error response fails the test.
    Answer request(const std::string& method, Json params) {
        const Answer response = ask(method, std::move(params));
        EXPECT_FALSE(response.has("error")) << response.write();
        return response["result"];
    }
    void notify(const std::string& method, Json params) {
        server_.receive_message(
            json_text(Json::object({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}})));
        work();
    }
    void raw(const std::string& text) {
        server_.receive_message(text);
        work();
    }
    void work() {
        while (server_.has_work()) server_.handle_next();
        server_.use_idle_time();
    }

    // Documents.

    void open(const std::string& uri, const std::string& text) {
        texts_[uri] = text;
        notify("textDocument/didOpen",
               Json::object(
                   {{"textDocument",
                     Json::object({{"uri", uri}, {"languageId", "robochart"}, {"version", 1}, {"text", text}})}}));
    }
    void change(const std::string& uri, const std::string& text) {
        texts_[uri] = text;
        changes(uri, Json::array({Json::object({{"text", text}})}));
    }
    void changes(const std::string& uri, Json list) {
        notify("textDocument/didChange",
               Json::object({{"textDocument", Json::object({{"uri", uri}, {"version", ++version_}})},
                             {"contentChanges", std::move(list)}}));
    }
    void close(const std::string& uri) {
        notify("textDocument/didClose", Json::object({{"textDocument", Json::object({{"uri", uri}})}}));
    }

    /// Returns `{textDocument, position}` for the place directly after `/*^mark*/`.
    [[nodiscard]] Json at(const std::string& mark, const std::string& uri = "file:///p/a.rct") const {
        return Json::object(
            {{"textDocument", Json::object({{"uri", uri}})}, {"position", position_of(offset(mark, uri), uri)}});
    }
    [[nodiscard]] std::size_t offset(const std::string& mark, const std::string& uri = "file:///p/a.rct") const {
        const std::string written = "/*^" + mark + "*/";
        const std::size_t found = texts_.at(uri).find(written);
        EXPECT_NE(found, std::string::npos) << "no mark " << mark;
        return found == std::string::npos ? 0 : found + written.size();
    }
    /// Returns the position of an offset in an ASCII text.
    [[nodiscard]] Json position_of(std::size_t offset, const std::string& uri) const {
        const std::string& text = texts_.at(uri);
        std::int64_t line = 0;
        std::size_t begin = 0;
        for (std::size_t i = 0; i < offset; ++i)
            if (text[i] == '\n') {
                ++line;
                begin = i + 1;
            }
        return Json::object({{"line", line}, {"character", offset - begin}});
    }
    /// Returns the names of the marks at each location, in order and joined by blanks, with "?" for a location without
    /// a mark.
    [[nodiscard]] std::string marks(const Answer& locations) const {
        std::string out;
        const Answer list = locations.is_array() ? locations : Json::array({locations.json()});
        for (const Answer& location : list.items()) out += (out.empty() ? "" : " ") + mark_at(location);
        return out;
    }
    [[nodiscard]] std::string mark_at(const Answer& location) const {
        const std::string& uri = location["uri"].text();
        if (!texts_.contains(uri)) return "?" + uri;
        const std::string before = text_before(uri, location["range"]["start"]);
        if (!before.ends_with("*/")) return "?";
        const std::size_t begin = before.rfind("/*^");
        return begin == std::string::npos ? "?" : before.substr(begin + 3, before.size() - begin - 5);
    }
    [[nodiscard]] std::string text_before(const std::string& uri, const Answer& position) const {
        const std::string& text = texts_.at(uri);
        std::size_t begin = 0;
        for (std::int64_t line = 0; line < position["line"].number(); ++line) begin = text.find('\n', begin) + 1;
        return text.substr(0, begin + static_cast<std::size_t>(position["character"].number()));
    }
    /// Returns the text of a document after a workspace edit.
    [[nodiscard]] std::string edited(const Answer& edit, const std::string& uri = "file:///p/a.rct") const {
        return applied(edit["changes"][uri], uri);
    }
    [[nodiscard]] std::string applied(const Answer& edits, const std::string& uri = "file:///p/a.rct") const {
        std::map<std::size_t, std::pair<std::size_t, std::string>> pieces;
        for (const Answer& edit : edits.items())
            pieces[text_before(uri, edit["range"]["start"]).size()] = {text_before(uri, edit["range"]["end"]).size(),
                                                                       edit["newText"].text()};
        std::string text = texts_.at(uri);
        for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece)
            text.replace(piece->first, piece->second.first - piece->first, piece->second.second);
        return text;
    }

    /// Returns the diagnostics last published for a document, or null if none were published.
    [[nodiscard]] Answer diagnostics(const std::string& uri = "file:///p/a.rct") const {
        Answer last;
        for (const Answer& message : messages)
            if (message["method"].text() == "textDocument/publishDiagnostics" && message["params"]["uri"].text() == uri)
                last = message["params"]["diagnostics"];
        return last;
    }
    /// Returns "CODE@line" for each error. Lines start at 1.
    [[nodiscard]] std::string codes(const std::string& uri = "file:///p/a.rct") const {
        constexpr std::int64_t error = 1;
        return codes_up_to(error, uri);
    }
    /// Returns "CODE@line" for each finding, including warnings. Lines start at 1.
    [[nodiscard]] std::string all_codes(const std::string& uri = "file:///p/a.rct") const {
        constexpr std::int64_t information = 3;
        return codes_up_to(information, uri);
    }
    [[nodiscard]] std::string codes_up_to(std::int64_t severity, const std::string& uri) const {
        std::string out;
        const Answer list = diagnostics(uri);
        for (const Answer& finding : list.items()) {
            if (finding["severity"].number() > severity) continue;
            out += (out.empty() ? "" : " ") + finding["code"].text() + "@" +
                   std::to_string(finding["range"]["start"]["line"].number() + 1);
        }
        return out;
    }

    [[nodiscard]] Server& server() { return server_; }
    [[nodiscard]] const Answer& initialized() const { return initialized_; }

    std::vector<Answer> messages;  ///< all messages from the server

private:
    void sent(const std::string& text) {
        std::string error;
        messages.push_back(read_json(text, error));
        EXPECT_EQ(error, "") << text;
        EXPECT_EQ(messages.back()["jsonrpc"].text(), "2.0");
    }

    Server server_;
    std::map<std::string, std::string> texts_;
    Answer initialized_;
    std::int64_t last_id_ = 0;
    std::int64_t version_ = 1;
};

}  // namespace robochart::lsp::testing
