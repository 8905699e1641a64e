// Texts that an editor has open beside models: scripts in CSPM, rules in SLEEC. Their changes and findings are the
// same for all languages.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "lsp/workspace/session.hpp"

namespace robochart::lsp {

/// An open document.
struct OpenText {
    std::string uri;
    std::string path;  ///< as in the URI
    SourceManager texts;
    SourceId source = SourceId::none;
    std::optional<std::int64_t> version;
    std::string pulled;  ///< the diagnostics last asked for
};

/// The document of a notification that it was opened: what `open` makes of URI and text, with its version.
void take_opened(View params, const std::function<OpenText&(const std::string& uri, std::string text)>& open);
/// Calls `change` with the text after each change of a notification, in their order.
void take_changes(OpenText& document, View params, Encoding encoding,
                  const std::function<void(std::string text)>& change);
/// The answer to a request for the findings of a document; they are noted as asked for.
[[nodiscard]] Json pulled_findings(OpenText& document, const std::map<std::string, Json>& found);

/// What the editor knows of findings.
class Published {
public:
    /// Sends those that have changed. Of open documents nothing is pushed to an editor that asks for their findings: it
    /// would show them twice. `opened`: null for what is not open.
    void send(Session& session, std::map<std::string, Json> found,
              const std::function<const OpenText*(const std::string& uri)>& opened);

private:
    std::map<std::string, std::string> sent_;  ///< the findings last sent, by URI
};

}  // namespace robochart::lsp
