// SPDX-License-Identifier: Apache-2.0
// Defines the settings negotiated with one editor, and the state of the connection.
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "editors/server/protocol/positions.hpp"

namespace robochart::lsp {

/// Error codes of JSON-RPC 2.0 and LSP 3.17.
enum class ErrorCode {
    parse_error = -32700,
    invalid_request = -32600,
    method_not_found = -32601,
    invalid_params = -32602,
    internal_error = -32603,
    not_initialized = -32002,
    request_cancelled = -32800,
    content_modified = -32801,
    request_failed = -32803,
};

/// A request that is rejected; sent as an error response.
class Refusal : public std::runtime_error {
public:
    Refusal(ErrorCode code, const std::string& why) : std::runtime_error(why), code_(code) {}
    [[nodiscard]] ErrorCode error_code() const { return code_; }

private:
    ErrorCode code_;
};

/// The capabilities of the editor.
struct Client {
    Encoding encoding = Encoding::utf16;
    bool hierarchical_symbols = false;
    bool snippets = false;
    bool markdown = false;
    bool watches_files = false;
    bool versioned_edits = false;
    bool creates_files = false;  ///< true if edits may create files; edits then have versions
    /// True if the editor requests the diagnostics of open documents, so the server does not send them.
    bool pulls_diagnostics = false;
    bool refreshes_diagnostics = false;  ///< it requests diagnostics again when the server notifies it
    std::set<std::string> commands;  ///< code lens commands that it supports (editors/server/features/capabilities.hpp)
};

/// The state of the connection, shared by all languages.
struct Session {
    explicit Session(diagnostics::Budget* limits) : budget(limits) {}

    Client client;
    diagnostics::Budget* budget;            ///< interrupts work; null: no limit
    std::int64_t refreshes = 0;             ///< number of requests to refresh diagnostics so far
    std::function<void(const Json&)> send;  ///< sends a message to the editor
    /// Returns the SLEEC rules of a folder, each with the name of its file. The function is empty if rules are not
    /// available.
    std::function<std::vector<std::pair<std::string, std::string>>(const std::string& folder)> rule_names;
};

}  // namespace robochart::lsp
