// SPDX-License-Identifier: Apache-2.0
// Positions as in LSP 3.17 (Position): lines and columns from 0; columns count code units of the negotiated encoding.
#pragma once

#include "base/diagnostics/source.hpp"
#include "editors/server/protocol/json.hpp"

namespace robochart::lsp {

using diagnostics::SourceId;
using diagnostics::SourceManager;
using diagnostics::Span;

/// The unit of a column.
enum class Encoding { utf8, utf16, utf32 };

/// `{line, character}` of a byte offset.
[[nodiscard]] Json lsp_position(const SourceManager&, SourceId, std::uint32_t offset, Encoding);
/// `{start, end}` of a span.
[[nodiscard]] Json lsp_range(const SourceManager&, Span, Encoding);
/// The byte offset of `{line, character}`. A position beyond the end of a line or of the text is that end.
[[nodiscard]] std::uint32_t offset_of(const SourceManager&, SourceId, View position, Encoding);
/// The span of `{start, end}`; the ends may be in either order.
[[nodiscard]] Span span_of(const SourceManager&, SourceId, View range, Encoding);

}  // namespace robochart::lsp
