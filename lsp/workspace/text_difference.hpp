// A new text as a change of an old one.
#pragma once

#include <string_view>

#include "lsp/protocol/positions.hpp"

namespace robochart::lsp {

/// TextEdits that turn a text into another: one of what lies between their common beginning and end, on bounds of
/// characters, so that the editor keeps its place; none where they are the same.
[[nodiscard]] Json text_edits(const SourceManager&, SourceId, std::string_view after, Encoding);

}  // namespace robochart::lsp
