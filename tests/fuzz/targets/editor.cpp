// SPDX-License-Identifier: Apache-2.0
// Tests the language server with any input: a session with an editor that types and sends requests at random, and
// arbitrary bytes on its input stream.
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <sstream>
#include <vector>

#include "editors/server/protocol/transport.hpp"
#include "editors/server/server.hpp"
#include "tests/fuzz/targets/targets.hpp"

namespace robochart::fuzz {

namespace {

using lsp::Json;

/// One project with CSPM scripts. None of the files exists on disk.
constexpr std::array<std::string_view, 5> uris = {"file:///fuzzed/a.rct", "file:///fuzzed/b.rct",
                                                  "file:///fuzzed/c.assertions", "file:///fuzzed/d.csp",
                                                  "file:///fuzzed/e.csp"};
constexpr std::size_t models = 3;
using Texts = std::array<std::optional<std::string>, uris.size()>;

constexpr std::array<std::string_view, 22> methods = {"textDocument/codeAction",
                                                      "textDocument/completion",
                                                      "textDocument/declaration",
                                                      "textDocument/definition",
                                                      "textDocument/documentHighlight",
                                                      "textDocument/documentSymbol",
                                                      "textDocument/foldingRange",
                                                      "textDocument/formatting",
                                                      "textDocument/hover",
                                                      "textDocument/prepareRename",
                                                      "textDocument/references",
                                                      "textDocument/rename",
                                                      "textDocument/semanticTokens/full",
                                                      "textDocument/signatureHelp",
                                                      "workspace/symbol",
                                                      "textDocument/codeLens",
                                                      "textDocument/diagnostic",
                                                      "textDocument/inlayHint",
                                                      "textDocument/prepareCallHierarchy",
                                                      "textDocument/selectionRange",
                                                      "callHierarchy/incomingCalls",
                                                      "callHierarchy/outgoingCalls"};

constexpr std::array<std::string_view, 8> pieces = {"",        "}",        "\n", "x",
                                                    "stm X {", "\xC3\xA9", "/*", "\xF0\x9F\x98\x80"};

/// An editor with a project. Records the first property that the server violates.
class Editor {
public:
    explicit Editor(const Texts& texts) : server_([this](const std::string& message) { receive_sent(message); }) {
        request("initialize", Json::object({{"capabilities", Json::object({})}}));
        notify("initialized", Json::object({}));
        for (std::size_t file = 0; file < texts.size(); ++file) {
            if (!texts[file]) continue;
            notify("textDocument/didOpen", Json::object({{"textDocument", Json::object({{"uri", uris[file]},
                                                                                        {"languageId", "robochart"},
                                                                                        {"version", 1},
                                                                                        {"text", *texts[file]}})}}));
        }
    }

    void type(std::size_t file, std::string text) {
        const Json document = Json::object({{"uri", uris[file]}, {"version", ++version_}});
        const Json changes = Json::array({Json::object({{"text", std::move(text)}})});
        notify("textDocument/didChange", Json::object({{"textDocument", document}, {"contentChanges", changes}}));
    }

    void ask(std::string_view method, std::size_t file, int line, int character) {
        const Json position = Json::object({{"line", line}, {"character", character}});
        const Json item = Json::object({{"uri", uris[file]}, {"selectionRange", Json::object({{"start", position}})}});
        request(method,
                Json::object({{"textDocument", Json::object({{"uri", uris[file]}})},
                              {"position", position},
                              {"positions", Json::array({position})},
                              {"item", item},
                              {"range", Json::object({{"start", position}, {"end", position}})},
                              {"context", Json::object({{"includeDeclaration", true}, {"diagnostics", Json::array()}})},
                              {"options", Json::object({{"tabSize", 4}})},
                              {"newName", "renamed"},
                              {"query", "a"}}));
    }

    [[nodiscard]] const std::string& complaint() const { return complaint_; }
    /// Returns the latest diagnostics of all files.
    [[nodiscard]] std::string shown_text() const {
        std::string all;
        for (const auto& [uri, list] : shown_)
            if (!list.empty()) all += uri + ": " + lsp::json_text(list) + "\n";
        return all;
    }

private:
    void receive_sent(const std::string& text) {
        std::string error;
        const Json json = lsp::read_json(text, error);
        const lsp::View message = json;
        if (!error.empty()) complain("a message is not JSON: " + error);
        if (message["method"].text() == "textDocument/publishDiagnostics")
            shown_[message["params"]["uri"].text()] = message["params"]["diagnostics"].json();
        if (message["method"].text() == "window/logMessage") complain("the server has a fault: " + text);
        if (message["error"]["code"].number_or() == static_cast<int>(lsp::ErrorCode::internal_error))
            complain("a request ends in a fault: " + text);
        if (message["id"].json() == Json(last_id_) && !message.has_key("method")) ++answers_;
    }
    void complain(std::string what) {
        if (complaint_.empty()) complaint_ = std::move(what);
    }
    void request(std::string_view method, Json params) {
        answers_ = 0;
        ++last_id_;
        deliver(
            Json::object({{"jsonrpc", "2.0"}, {"id", last_id_}, {"method", method}, {"params", std::move(params)}}));
        if (answers_ != 1) complain(std::to_string(answers_) + " answers to " + std::string(method));
    }
    void notify(std::string_view method, Json params) {
        deliver(Json::object({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}}));
    }
    void deliver(const Json& message) {
        server_.receive_message(lsp::json_text(message));
        while (server_.has_work()) server_.handle_next();
        server_.use_idle_time();
    }

    std::string complaint_;
    std::map<std::string, Json> shown_;
    std::int64_t last_id_ = 0;
    std::int64_t version_ = 1;
    int answers_ = 0;
    lsp::Server server_;
};

/// Returns the bytes as text for JSON. Bytes above 127 become question marks.
std::string as_text(std::string_view bytes) {
    std::string text(bytes);
    for (char& c : text)
        if (static_cast<unsigned char>(c) >= 0x80U) c = '?';
    return text;
}

bool is_plain(const std::string& text, std::size_t place) {
    return place < text.size() && static_cast<unsigned char>(text[place]) < 0x80U;
}

/// Returns the start of the UTF-8 character at this position.
std::size_t character_begin(const std::string& text, std::size_t place) {
    while (place < text.size() && (static_cast<unsigned char>(text[place]) & 0xC0U) == 0x80U) --place;
    return place;
}

/// Returns the texts of the files, in order. There may be fewer texts than files.
Texts divide_texts(const std::string& text) {
    Texts texts;
    std::size_t begin = 0;
    for (auto& piece : texts) {
        const std::size_t end = text.find('\f', begin);
        piece = text.substr(begin, end - begin);
        if (end == std::string::npos) break;
        begin = end + 1;
    }
    return texts;
}

/// Returns whether the input may name files on disk. Such files are not part of the input, so this is not allowed.
bool may_name_files(std::string_view bytes) {
    constexpr std::array<std::string_view, 7> signs = {"file:", "root", "Folders\":[", "added", "\"/", "\\/", "\\u002"};
    return std::ranges::any_of(signs,
                               [&](std::string_view sign) { return bytes.find(sign) != std::string_view::npos; });
}

}  // namespace

/// Runs a session. The first line contains the actions, three bytes per step. The other lines are the documents,
/// separated by form feeds.
std::string run_editor(std::string_view bytes) {
    constexpr std::size_t most_steps = 24;
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    Texts texts = divide_texts(as_text(bytes.substr(std::min(end + 1, bytes.size()))));
    Editor editor(texts);
    for (std::size_t at = 0; at + 3 <= std::min(end, 3 * most_steps); at += 3) {
        const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[at + i]); };
        const std::size_t choice = byte(0) / 32U % (texts[models] ? texts.size() : models);
        const std::size_t file = texts[choice] ? choice : 0;
        if (byte(0) % 2 == 0) {
            editor.ask(methods.at(byte(0) / 2U % methods.size()), file, byte(1) % 64, byte(2) % 128);
            continue;
        }
        std::string& text = *texts[file];
        const std::size_t place = character_begin(text, (byte(1) * 256U + byte(2)) % (text.size() + 1));
        text.insert(place, pieces.at(byte(0) / 2U % pieces.size()));
        if (byte(0) / 2U % pieces.size() == 0 && is_plain(text, place)) text.erase(place, 1);
        editor.type(file, text);
    }
    if (!editor.complaint().empty()) return editor.complaint();
    const Editor fresh(texts);
    return editor.shown_text() == fresh.shown_text()
               ? ""
               : "diagnostics depend on how the text was typed:\n" + editor.shown_text() + "/\n" + fresh.shown_text();
}

/// Serves the bytes as a stream. The server handles every message and every error of the stream, and ends at the end of
/// the stream.
std::string run_stream(std::string_view bytes) {
    if (may_name_files(bytes)) return {};
    std::istringstream in{std::string(bytes)};
    lsp::FrameReader reader(in);
    std::vector<std::string> sent;
    lsp::Server server([&](const std::string& message) { sent.push_back(message); });
    for (lsp::Frame frame = reader.next_frame(); frame.kind != lsp::Frame::Kind::end; frame = reader.next_frame()) {
        if (frame.kind == lsp::Frame::Kind::message)
            server.receive_message(frame.text);
        else
            server.receive_message(nullptr, frame.text);
        while (server.has_work()) server.handle_next();
        server.use_idle_time();
    }
    for (const std::string& message : sent) {
        std::string error;
        const Json read = lsp::read_json(message, error);
        if (!error.empty() || lsp::View(read)["jsonrpc"].text() != "2.0") return "a message is no JSON-RPC: " + message;
    }
    return {};
}

}  // namespace robochart::fuzz
