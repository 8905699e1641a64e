// SPDX-License-Identifier: Apache-2.0
// The settings negotiated with one editor, and the interface of request handlers.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "editors/server/protocol/json.hpp"
#include "editors/server/workspace/workspace.hpp"

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
    /// True if the editor requests the diagnostics of open documents, so the server does not send them.
    bool pulls_diagnostics = false;
    bool refreshes_diagnostics = false;  ///< repeats its requests for diagnostics when the server notifies it
    std::set<std::string> commands;  ///< code lens commands that it supports (editors/server/features/capabilities.hpp)
};

class KeptDiagrams;

struct Session {
    explicit Session(diagnostics::Budget* limits = nullptr) : workspace(limits), budget(limits) {}

    Workspace workspace;
    Client client;
    diagnostics::Budget* budget;  ///< interrupts work; null: no limit
    std::shared_ptr<KeptDiagrams>
        diagrams;                ///< created by the first request for a diagram (editors/server/features/diagram.hpp)
    std::int64_t refreshes = 0;  ///< number of requests to refresh diagnostics so far
    std::function<void(const Json&)> send;  ///< sends a message to the editor
    /// The SLEEC rules of a folder, each with the name of its file; an empty function: not available.
    std::function<std::vector<std::pair<std::string, std::string>>(const std::string& folder)> rule_names;
};

/// The place in a document that a request is about.
struct Target {
    Project& project;
    Document& document;
    std::uint32_t offset = 0;
};

/// The document of `params.textDocument`, and the offset of `params.position`, if given. Rejects unknown documents.
[[nodiscard]] Target target_of(Session&, View params);
/// The findings about the target's document, sorted by place; parse errors come first.
[[nodiscard]] std::vector<diagnostics::Diagnostic> findings_about(const Target&);
/// `{uri, range}` of a span of the project; null if it is in no file.
[[nodiscard]] Json lsp_location(const Session&, Project&, Span);

}  // namespace robochart::lsp
