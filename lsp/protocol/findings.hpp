// Findings of the rules as messages of the protocol (LSP 3.17, Diagnostic), whatever language they are about.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "lsp/protocol/positions.hpp"

namespace robochart::lsp {

/// `{uri, range}` of a span; null if it lies in no file that the editor can open.
using Locate = std::function<Json(Span)>;

/// A finding as a Diagnostic.
[[nodiscard]] Json diagnostic(const SourceManager&, const diagnostics::Diagnostic&, Encoding, const Locate&);
/// A list of them as text, to compare; "" if it is empty.
[[nodiscard]] std::string text_of_findings(const Json& list);
/// The notification with the findings about a document.
[[nodiscard]] Json publication(const std::string& uri, std::optional<std::int64_t> version, Json list);
/// The request that the editor asks for findings again; they are numbered.
[[nodiscard]] Json refresh_request(std::int64_t number);

/// Why rules object at an offset: their codes and explanations, each once. "" if none does.
[[nodiscard]] std::string explanations(const std::vector<diagnostics::Diagnostic>& findings, std::uint32_t offset,
                                       bool markdown);
/// The answer to a hover; null without a text. `place` may be unknown.
[[nodiscard]] Json hover_answer(const SourceManager&, std::string text, Span place, Encoding, bool markdown);

}  // namespace robochart::lsp
