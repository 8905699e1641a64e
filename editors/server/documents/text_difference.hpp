// SPDX-License-Identifier: Apache-2.0
// Expresses a new text as a change of an old one.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "editors/server/protocol/positions.hpp"

namespace robochart::lsp {

/// TextEdits that turn a text into another. One edit replaces the part between the common beginning and the common end,
/// at character boundaries, so that the editor keeps its cursor position. Empty if the texts are equal.
[[nodiscard]] Json text_edits(const SourceManager&, SourceId, std::string_view after, Encoding);

/// The edits that format a text. A text with syntax errors has no formatted text and is refused; its diagnostics give
/// the reason.
[[nodiscard]] Json formatting_edits(const SourceManager&, SourceId, const std::optional<std::string>& formatted,
                                    Encoding);

}  // namespace robochart::lsp
