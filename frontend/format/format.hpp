// The standard layout of RoboChart and assertion text (docs/format.md). Only blanks and line ends change: words,
// comments, CSP blocks and parts of other tools stay as they are written.
#pragma once

#include <optional>
#include <string>

#include "diagnostics/diagnostic.hpp"
#include "diagnostics/source.hpp"

namespace robochart::frontend {

/// The text in the standard layout; formatting it again changes nothing. Nothing if the text has syntax errors, which
/// are reported. Throws std::logic_error if a word or comment would be lost: an internal error, never the text's.
[[nodiscard]] std::optional<std::string> format(const diagnostics::SourceManager&, diagnostics::SourceId,
                                                bool is_assertions, diagnostics::Diagnostics&);

/// Do two texts have the same words and the same comments, blanks and line ends aside?
[[nodiscard]] bool same_words(const std::string& a, const std::string& b, bool is_assertions);

}  // namespace robochart::frontend
