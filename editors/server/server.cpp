// SPDX-License-Identifier: Apache-2.0
// Handles the states, requests and notifications of the protocol, and sends diagnostics when no message is queued.
#include "editors/server/server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "editors/server/features/capabilities.hpp"
#include "editors/server/features/diagram.hpp"

namespace robochart::lsp {

namespace {

/// A request about a document.
struct RequestRow {
    std::string_view method;
    Json (Language::*answer)(const Request&);
};
/// A notification about a document.
struct NotificationRow {
    std::string_view method;
    void (Language::*handle)(View params);
};

constexpr std::array requests = {
    RequestRow{"callHierarchy/incomingCalls", &Language::incoming_calls},
    RequestRow{"callHierarchy/outgoingCalls", &Language::outgoing_calls},
    RequestRow{diagram_request, &Language::diagram},
    RequestRow{"textDocument/codeAction", &Language::code_actions},
    RequestRow{"textDocument/codeLens", &Language::code_lenses},
    RequestRow{"textDocument/completion", &Language::completion},
    RequestRow{"textDocument/declaration", &Language::definition},
    RequestRow{"textDocument/definition", &Language::definition},
    RequestRow{"textDocument/diagnostic", &Language::pull_findings},
    RequestRow{"textDocument/documentHighlight", &Language::highlights},
    RequestRow{"textDocument/documentSymbol", &Language::document_symbols},
    RequestRow{"textDocument/foldingRange", &Language::folding_ranges},
    RequestRow{"textDocument/formatting", &Language::formatting},
    RequestRow{"textDocument/hover", &Language::hover},
    RequestRow{"textDocument/inlayHint", &Language::inlay_hints},
    RequestRow{"textDocument/prepareCallHierarchy", &Language::prepare_call_hierarchy},
    RequestRow{"textDocument/prepareRename", &Language::prepare_rename},
    RequestRow{"textDocument/references", &Language::references},
    RequestRow{"textDocument/rename", &Language::rename},
    RequestRow{"textDocument/selectionRange", &Language::selection_ranges},
    RequestRow{"textDocument/semanticTokens/full", &Language::semantic_tokens},
    RequestRow{"textDocument/signatureHelp", &Language::signature_help},
};

constexpr std::array notifications = {
    NotificationRow{"textDocument/didOpen", &Language::did_open},
    NotificationRow{"textDocument/didChange", &Language::did_change},
    NotificationRow{"textDocument/didClose", &Language::did_close},
};

template <class Rows>
auto row_of(const Rows& rows, std::string_view method) {
    return std::ranges::find_if(rows, [&](const auto& row) { return row.method == method; });
}

bool is_id(View id) {
    return id.is_text() || id.is_number();
}

diagnostics::Limits limits_of(const Interruption& interruption) {
    diagnostics::Limits limits;
    limits.memory_bytes = std::numeric_limits<std::uint64_t>::max();
    limits.interrupted = [&interruption] { return interruption.current_reason() != Interruption::Reason::none; };
    return limits;
}

}  // namespace

Server::Server(std::function<void(const std::string&)> send)
    : budget_(limits_of(interruption_)),
      session_(&budget_),
      scripts_(session_),
      rules_(session_),
      claims_(session_),
      plain_(session_),
      models_(session_) {
    session_.rule_names = [this](const std::string& folder) { return rules_.names_in(folder); };
    session_.send = [send = std::move(send)](const Json& message) { send(json_text(message)); };
}

void Server::receive_message(const std::string& text) {
    std::string fault;
    Json message = read_json(text, fault);
    receive_message(std::move(message), std::move(fault));
}

void Server::receive_message(Json message, std::string fault) {
    queue_.push_back({std::move(message), std::move(fault)});
}

void Server::handle_next() {
    const Message message = std::move(queue_.front());
    queue_.pop_front();
    if (exit_code_) return;
    if (!message.fault.empty()) return send_error(nullptr, ErrorCode::parse_error, message.fault);
    interruption_.note_handled(message.json);
    handle_message(message.json);
}

void Server::use_idle_time() {
    if (phase_ != Phase::running || exit_code_) return;
    const Interruption::Work work(interruption_, nullptr);
    try {
        for (Language* language : languages_) language->publish();
    } catch (const diagnostics::LimitReached&) {
        // Newer messages are handled first; then the diagnostics are sent again.
    } catch (const std::exception& error) {
        log_message("diagnostics", error.what());
    }
}

void Server::handle_message(View message) {
    if (!message.is_object()) return send_error(nullptr, ErrorCode::invalid_request, "a message must be an object");
    const bool is_response = !message.has_key("method") && message.has_key("id");
    if (is_response) return;
    if (!message["method"].is_text())
        return send_error(nullptr, ErrorCode::invalid_request, "a message without a method");
    if (message.has_key("id")) return handle_request(message);
    handle_notification(message["method"].text(), message["params"]);
}

bool Server::is_cancelled(const Json& id) const {
    return interruption_.is_cancelled(id) || std::ranges::any_of(queue_, [&](const Message& m) {
               const View message = m.json;
               return message["method"].text() == "$/cancelRequest" && message["params"]["id"].json() == id;
           });
}

void Server::handle_request(View message) {
    const Json& id = message["id"].json();
    if (!is_id(id)) return send_error(nullptr, ErrorCode::invalid_request, "an id must be a number or a string");
    // `shutdown` is always handled.
    if (message["method"].text() != "shutdown" && is_cancelled(id))
        return send_error(id, ErrorCode::request_cancelled, "cancelled");
    const Interruption::Work work(interruption_, id);
    try {
        send_response(id, answer_request(message["method"].text(), message["params"]));
    } catch (const diagnostics::LimitReached&) {
        ended_early(id);
    } catch (const Refusal& refusal) {
        send_error(id, refusal.error_code(), refusal.what());
    } catch (const std::exception& error) {
        send_error(id, ErrorCode::internal_error, fmt::format("internal error: {}", error.what()));
    }
}

void Server::ended_early(const Json& id) {
    if (interruption_.current_reason() == Interruption::Reason::modified)
        return send_error(id, ErrorCode::content_modified, "the text has changed meanwhile");
    send_error(id, ErrorCode::request_cancelled, "cancelled");
}

Json Server::answer_request(const std::string& method, View params) {
    if (method == "initialize") return initialize(params);
    if (phase_ == Phase::fresh) throw Refusal(ErrorCode::not_initialized, "the first request must be `initialize`");
    if (phase_ == Phase::shut_down) throw Refusal(ErrorCode::invalid_request, "after `shutdown` only `exit` may come");
    if (method == "shutdown") {
        phase_ = Phase::shut_down;
        return nullptr;
    }
    if (method == "workspace/symbol") return models_.workspace_symbols(params["query"].text());
    const auto row = row_of(requests, method);
    if (row == requests.end()) throw Refusal(ErrorCode::method_not_found, fmt::format("no method `{}`", method));
    Language& language = language_of(params);
    return (language.*row->answer)(language.request_of(params));
}

Json Server::initialize(View params) {
    if (phase_ != Phase::fresh) throw Refusal(ErrorCode::invalid_request, "`initialize` may come once");
    session_.client = client_of(params);
    for (const std::string& folder : folders_of(params)) models_.add_folder(folder);
    phase_ = Phase::running;
    return server_capabilities(session_.client);
}

Language& Server::language_of(View params) {
    const View document = params["textDocument"];
    const std::string& uri = document.is_null() ? params["item"]["uri"].text() : document["uri"].text();
    for (Language* language : languages_)
        if (language->accepts(uri, document["languageId"].text()) || language->find(uri) != nullptr) return *language;
    return models_;
}

void Server::change_files(View changes) {
    for (const View change : changes.items())
        for (Language* language : languages_) language->refresh_file(change["uri"].text());
}

void Server::change_folders(View event) {
    for (const View folder : event["removed"].items()) models_.remove_folder(path_of_uri(folder["uri"].text()));
    for (const View folder : event["added"].items()) models_.add_folder(path_of_uri(folder["uri"].text()));
}

/// Handles a notification. Notifications have no answer, so errors are only sent to the editor's log.
void Server::handle_notification(const std::string& method, View params) {
    if (method == "exit") {
        exit_code_ = phase_ == Phase::shut_down ? 0 : 1;
        return;
    }
    if (phase_ != Phase::running) return;
    const auto row = row_of(notifications, method);
    try {
        if (method == "initialized" && session_.client.watches_files) session_.send(watch_request());
        if (method == "workspace/didChangeWatchedFiles") change_files(params["changes"]);
        if (method == "workspace/didChangeWorkspaceFolders") change_folders(params["event"]);
        if (row != notifications.end()) (language_of(params).*row->handle)(params);
    } catch (const std::exception& error) {
        log_message(method, error.what());
    }
}

void Server::log_message(const std::string& where, const char* what) {
    constexpr int error_type = 1;
    const Json params = Json::object({{"type", error_type}, {"message", fmt::format("{}: {}", where, what)}});
    session_.send(Json::object({{"jsonrpc", "2.0"}, {"method", "window/logMessage"}, {"params", params}}));
}

void Server::send_response(const Json& id, Json result) {
    session_.send(Json::object({{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}}));
}

void Server::send_error(const Json& id, ErrorCode code, const std::string& why) {
    session_.send(Json::object({{"jsonrpc", "2.0"},
                                {"id", id},
                                {"error", Json::object({{"code", static_cast<int>(code)}, {"message", why}})}}));
}

}  // namespace robochart::lsp
