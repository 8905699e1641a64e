// SPDX-License-Identifier: Apache-2.0
// Expresses a new text as a change of an old one.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "editors/server/protocol/positions.hpp"

namespace robochart::lsp {

/// Returns TextEdits that turn a text into another. One edit replaces the part between the common beginning and the
/// common end, at character boundaries, so that the editor keeps its cursor position. The list is empty if the texts
/// are equal.
[[nodiscard]] Json text_edits(const SourceManager&, SourceId, std::string_view after, Encoding);

/// Returns the edits that format a text. Refuses a text with syntax errors, which has no formatted text; its
/// diagnostics contain the reason.
[[nodiscard]] Json formatting_edits(const SourceManager&, SourceId, const std::optional<std::string>& formatted,
                                    Encoding);

}  // namespace robochart::lsp
