// SPDX-License-Identifier: Apache-2.0
// Formats SLEEC files in the standard layout (docs/format.md, "Rules in SLEEC"). Only blanks and line ends change, not
// tokens and comments.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics/diagnostic.hpp"
#include "base/diagnostics/source.hpp"

namespace robochart::sleec {

/// Returns the text in the standard layout; formatting the result again does not change it. Returns no value if the
/// text has syntax errors, which are reported. Throws std::logic_error if a token or comment would be lost, which is an
/// internal error.
[[nodiscard]] std::optional<std::string> format(const diagnostics::SourceManager&, diagnostics::SourceId,
                                                diagnostics::Diagnostics&);

}  // namespace robochart::sleec
