// What one editor has agreed upon with the server, and the shape of request handlers.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "lsp/protocol/json.hpp"
#include "lsp/workspace/workspace.hpp"

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

/// A request that cannot be answered; becomes an error response.
class Refusal : public std::runtime_error {
public:
    Refusal(ErrorCode code, const std::string& why) : std::runtime_error(why), code_(code) {}
    [[nodiscard]] ErrorCode code() const { return code_; }

private:
    ErrorCode code_;
};

/// What the editor said it understands.
struct Client {
    Encoding encoding = Encoding::utf16;
    bool hierarchical_symbols = false;
    bool snippets = false;
    bool markdown = false;
    bool watches_files = false;
    bool versioned_edits = false;
    bool pulls_diagnostics = false;      ///< asks for those of open documents, so they are not pushed
    bool refreshes_diagnostics = false;  ///< asks again when it is notified
    std::set<std::string> commands;      ///< those of lenses that it has (lsp/features/capabilities.hpp)
};

class KeptDiagrams;

struct Session {
    explicit Session(diagnostics::Budget* limits = nullptr) : workspace(limits), budget(limits) {}

    Workspace workspace;
    Client client;
    diagnostics::Budget* budget;             ///< ends what should end; null for none
    std::shared_ptr<KeptDiagrams> diagrams;  ///< made when one is asked for first (lsp/features/diagram.hpp)
    std::int64_t refreshes = 0;              ///< requests to ask for diagnostics again, so far
    std::function<void(const Json&)> send;   ///< messages to the editor
    /// The rules in SLEEC of a folder, each with the name of its file; empty: nobody knows.
    std::function<std::vector<std::pair<std::string, std::string>>(const std::string& folder)> rule_names;
};

/// A place in a document that a request is about.
struct Target {
    Project& project;
    Document& document;
    std::uint32_t offset = 0;
};

/// The document of `params.textDocument`, and the offset of `params.position` where there is one. Refuses documents
/// that are not known.
[[nodiscard]] Target target_of(Session&, View params);
/// Findings about the target's document, by place; those of reading first.
[[nodiscard]] std::vector<diagnostics::Diagnostic> findings_about(const Target&);
/// `{uri, range}` of a span of the project; null if it lies in no file.
[[nodiscard]] Json location(const Session&, Project&, Span);

}  // namespace robochart::lsp
