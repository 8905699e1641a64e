// SPDX-License-Identifier: Apache-2.0
// Converts CSPM text to syntax trees and back.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "base/diagnostics/diagnostic.hpp"
#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::cspm {

/// Parses a text. `include` declarations stay in the tree. Errors are reported as diagnostics, and the rest of the text
/// is still parsed.
[[nodiscard]] Script read(const diagnostics::SourceManager&, diagnostics::SourceId, diagnostics::Diagnostics&);
/// Parses a file, and replaces its includes by the contents of the included files. Their paths are relative to the
/// including file. A file is included only once in each list. Cycles of includes are errors, and so is an excessive
/// size (see reader.cpp).
[[nodiscard]] Script read_file(diagnostics::SourceManager&, const std::string& path, diagnostics::Diagnostics&);

/// A function that adds the text of a file to the sources. On failure it returns no value and sets `error` to a
/// description of the cause.
using Loader = std::function<std::optional<diagnostics::SourceId>(const std::string& path, std::string& error)>;
/// Parses a file like the function above, but `load` may replace the texts of some files.
[[nodiscard]] Script read_file(diagnostics::SourceManager&, const std::string& path, diagnostics::Diagnostics&,
                               const Loader& load);

/// Prints a tree as text that FDR accepts and that `read` converts back to an equal tree. The text is the same each
/// time, and its lines have up to about 110 columns.
[[nodiscard]] std::string print(const Script&);
[[nodiscard]] std::string print(const ExprPtr&);
/// Prints a declaration without its comment and without a final line end.
[[nodiscard]] std::string print(const Decl&);

}  // namespace robochart::cspm
