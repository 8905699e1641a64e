// SPDX-License-Identifier: Apache-2.0
// Formats RoboChart models and assertion files in the standard layout (docs/format.md). Changes only blanks and line
// ends. Does not change tokens, comments, CSP blocks or parts for other tools.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics/diagnostic.hpp"
#include "base/diagnostics/source.hpp"

namespace robochart::frontend {

/// Returns the text in the standard layout. Formatting it again changes nothing. If the text has syntax errors,
/// reports them and returns no value. Throws std::logic_error if a token or comment would be lost, which is an
/// internal error.
[[nodiscard]] std::optional<std::string> format(const diagnostics::SourceManager&, diagnostics::SourceId,
                                                bool is_assertions, diagnostics::Diagnostics&);

/// True if two texts have the same tokens and comments in the dialect of `path`; blanks and line ends are ignored.
[[nodiscard]] bool same_words(const std::string& a, const std::string& b, bool is_assertions,
                              const std::string& path = {});

}  // namespace robochart::frontend
