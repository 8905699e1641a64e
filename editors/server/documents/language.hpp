// SPDX-License-Identifier: Apache-2.0
// Defines the interface of a language: its documents, their findings, and its answers to requests (LSP 3.17, language
// features). The server finds the language of a document, and the language does the rest.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "editors/server/documents/session.hpp"
#include "editors/server/protocol/uri.hpp"

namespace robochart::lsp {

/// A document of a language.
struct TextDocument {
    TextDocument(SourceManager& in, std::string at) : sources(in), uri(std::move(at)), path(path_of_uri(uri)) {}

    SourceManager& sources;  ///< contains the text
    std::string uri;         ///< the URI as the editor writes it
    std::string path;
    std::string language_id;  ///< identifier from the editor; may be empty
    SourceId source = SourceId::none;
    bool open = true;  ///< true if the text is that of the editor
    std::optional<std::int64_t> version;
    std::string pulled;  ///< the diagnostics that the editor last requested, while the document is open
};

/// A request about a place in a document.
struct Request {
    TextDocument& document;
    std::uint32_t offset;  ///< 0 if the request has no position
    View params;
};

/// A text to show at the pointer, and the place that the text describes, which may be unknown.
struct Hover {
    std::string text;
    Span place;
};

/// The documents in one language. The server calls the public functions; a language implements the virtual ones.
class Language {
public:
    explicit Language(Session& session) : session_(session) {}
    Language(const Language&) = delete;
    Language& operator=(const Language&) = delete;
    virtual ~Language() = default;

    /// True if a document belongs to the language, according to its name or to the language identifier from the editor.
    [[nodiscard]] virtual bool accepts(std::string_view uri, std::string_view language_id) const = 0;
    /// Returns the document with this URI; null if the language does not have it.
    [[nodiscard]] virtual TextDocument* find(std::string_view uri) = 0;
    /// Must be called when a file has changed on disk.
    virtual void refresh_file(const std::string& /*uri*/) {}
    /// Sends the findings that changed to the editor.
    virtual void publish() = 0;

    // Notifications about a document (LSP 3.17, text document synchronization)
    void did_open(View params);
    /// Applies the changes in order, each to the result of the one before. Rejects unknown documents.
    void did_change(View params);
    /// The document may be unknown.
    void did_close(View params);

    /// Returns the document and the place that a request is about: `textDocument` and `position`, or the document and
    /// place of `item`. Rejects unknown documents.
    [[nodiscard]] Request request_of(View params);
    /// Returns the findings of one document, for editors that request them.
    [[nodiscard]] Json pull_findings(const Request&);

    // Requests. The functions return null if the language does not support the request.
    [[nodiscard]] virtual Json code_actions(const Request&) { return {}; }
    [[nodiscard]] virtual Json code_lenses(const Request&) { return {}; }
    [[nodiscard]] virtual Json completion(const Request&) { return {}; }
    [[nodiscard]] virtual Json definition(const Request&) { return {}; }
    [[nodiscard]] virtual Json diagram(const Request&) { return {}; }
    [[nodiscard]] virtual Json document_symbols(const Request&) { return {}; }
    [[nodiscard]] virtual Json folding_ranges(const Request&) { return {}; }
    [[nodiscard]] virtual Json formatting(const Request&) { return {}; }
    [[nodiscard]] virtual Json highlights(const Request&) { return {}; }
    [[nodiscard]] virtual Json hover(const Request&) { return {}; }
    [[nodiscard]] virtual Json incoming_calls(const Request&) { return {}; }
    [[nodiscard]] virtual Json inlay_hints(const Request&) { return {}; }
    [[nodiscard]] virtual Json outgoing_calls(const Request&) { return {}; }
    [[nodiscard]] virtual Json prepare_call_hierarchy(const Request&) { return {}; }
    [[nodiscard]] virtual Json prepare_rename(const Request&) { return {}; }
    [[nodiscard]] virtual Json references(const Request&) { return {}; }
    [[nodiscard]] virtual Json rename(const Request&) { return {}; }
    [[nodiscard]] virtual Json selection_ranges(const Request&) { return {}; }
    [[nodiscard]] virtual Json semantic_tokens(const Request&) { return {}; }
    [[nodiscard]] virtual Json signature_help(const Request&) { return {}; }

protected:
    /// Adds a document, or replaces its text.
    virtual TextDocument& open_document(const std::string& uri, std::string text) = 0;
    virtual void change(TextDocument& document, std::string text) = 0;
    /// The document may be unknown.
    virtual void close(const std::string& uri) = 0;
    /// Returns the findings of a document, as an array of Diagnostics.
    [[nodiscard]] virtual Json findings_in(TextDocument& document) = 0;

    /// Returns `{uri, range}` of a span of the document; null if the span is unknown.
    [[nodiscard]] Json location_in(const TextDocument& document, Span span) const;
    /// Returns these findings as Diagnostics. All places must be in the document.
    [[nodiscard]] Json list_findings(const TextDocument& document, const diagnostics::Diagnostics& findings) const;
    /// Returns the answer to a hover request: the text, then the explanations of the rules that report the place.
    /// Returns null if both are empty.
    [[nodiscard]] Json hover_answer(const Request&, Hover hover,
                                    const std::vector<diagnostics::Diagnostic>& findings) const;
    /// Sends the lists of findings that changed, and an empty list for each document that the language no longer has.
    /// `found` maps URIs to lists. If the editor requests the findings of open documents, the server does not also send
    /// them, because the editor would show them twice.
    void send_findings(std::map<std::string, Json> found);

    Session& session_;

private:
    std::map<std::string, std::string> sent_;  ///< the findings last sent, by URI
};

}  // namespace robochart::lsp
