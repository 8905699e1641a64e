// The standard layout of SLEEC files (docs/format.md, "Rules in SLEEC"). Only blanks and line ends change: words and
// comments stay as they are written.
#pragma once

#include <optional>
#include <string>

#include "diagnostics/diagnostic.hpp"
#include "diagnostics/source.hpp"

namespace robochart::sleec {

/// The text in the standard layout; formatting it again changes nothing. Nothing if the text has syntax errors, which
/// are reported. Throws std::logic_error if a word or comment would be lost: an internal error, never the text's.
[[nodiscard]] std::optional<std::string> format(const diagnostics::SourceManager&, diagnostics::SourceId,
                                                diagnostics::Diagnostics&);

}  // namespace robochart::sleec
