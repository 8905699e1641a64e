// SPDX-License-Identifier: Apache-2.0
// Open texts in languages other than RoboChart: CSPM scripts, SLEEC rules. Changes and findings are handled in the same
// way for all languages.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "editors/server/workspace/session.hpp"

namespace robochart::lsp {

/// An open document.
struct OpenText {
    std::string uri;
    std::string path;  ///< as in the URI
    SourceManager texts;
    SourceId source = SourceId::none;
    std::optional<std::int64_t> version;
    std::string pulled;  ///< the diagnostics that the editor last requested
};

/// Handles a notification that a document was opened: calls `open` with URI and text, and stores the version.
void take_opened(View params, const std::function<OpenText&(const std::string& uri, std::string text)>& open);
/// Calls `change` with the text after each change of a notification, in order.
void take_changes(OpenText& document, View params, Encoding encoding,
                  const std::function<void(std::string text)>& change);
/// The answer to a request for the findings of a document. The findings are stored as the last ones that the editor
/// requested.
[[nodiscard]] Json pulled_findings(OpenText& document, const std::map<std::string, Json>& found);

/// The findings that the editor has received.
class Published {
public:
    /// Sends the findings that changed. If the editor requests the findings of open documents, the server does not send
    /// them as well, because the editor would show them twice. `opened`: null for a document that is not open.
    void send_findings(Session& session, std::map<std::string, Json> found,
                       const std::function<const OpenText*(const std::string& uri)>& opened);

private:
    std::map<std::string, std::string> sent_;  ///< the findings last sent, by URI
};

}  // namespace robochart::lsp
