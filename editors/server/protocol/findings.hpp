// SPDX-License-Identifier: Apache-2.0
// Findings of rules as messages of the protocol (LSP 3.17, Diagnostic), for all languages.
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

/// A finding as a Diagnostic.
[[nodiscard]] Json lsp_diagnostic(const SourceManager&, const diagnostics::Diagnostic&, Encoding, const Locate&);
/// A list of diagnostics as text, for comparisons; "" if it is empty.
[[nodiscard]] std::string text_of_findings(const Json& list);
/// The notification with the findings about a document.
[[nodiscard]] Json publication_message(const std::string& uri, std::optional<std::int64_t> version, Json list);
/// Asks the editor to request the findings again. Requests are numbered.
[[nodiscard]] Json refresh_request(std::int64_t number);

/// The codes and explanations of the rules that report the text at an offset, without duplicates; "" if there are none.
[[nodiscard]] std::string explain_findings(const std::vector<diagnostics::Diagnostic>& findings, std::uint32_t offset,
                                           bool markdown);

}  // namespace robochart::lsp
