// SPDX-License-Identifier: Apache-2.0
// Converts findings of rules to messages of the protocol (LSP 3.17, Diagnostic), for all languages.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "editors/server/protocol/positions.hpp"

namespace robochart::lsp {

/// Returns `{uri, range}` of a span; null if it is not in a file that the editor can open.
using Locate = std::function<Json(Span)>;

/// Returns a finding as a Diagnostic.
[[nodiscard]] Json lsp_diagnostic(const SourceManager&, const diagnostics::Diagnostic&, Encoding, const Locate&);
/// Returns a list of diagnostics as text, for comparisons; "" if the list is empty.
[[nodiscard]] std::string text_of_findings(const Json& list);
/// Returns the notification with the findings about a document.
[[nodiscard]] Json publication_message(const std::string& uri, std::optional<std::int64_t> version, Json list);
/// Returns a message that asks the editor to request the findings again. These messages are numbered.
[[nodiscard]] Json refresh_request(std::int64_t number);

/// Returns the codes and explanations of the rules that report the text at an offset, without duplicates; "" if there
/// are none.
[[nodiscard]] std::string explain_findings(const std::vector<diagnostics::Diagnostic>& findings, std::uint32_t offset,
                                           bool markdown);

}  // namespace robochart::lsp
