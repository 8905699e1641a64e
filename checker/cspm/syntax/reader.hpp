// SPDX-License-Identifier: Apache-2.0
// Converts CSPM text to syntax trees and back.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "base/diagnostics/diagnostic.hpp"
#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::cspm {

/// Parses a text. The tree keeps `include` declarations. Reports errors as diagnostics and still parses the rest of the
/// text.
[[nodiscard]] Script read(const diagnostics::SourceManager&, diagnostics::SourceId, diagnostics::Diagnostics&);
/// Parses a file and replaces its includes by the contents of the files. Paths are relative to the including file. A
/// list includes the same file only once. A cycle of includes is an error, and so is a script that becomes too large
/// (see reader.cpp).
[[nodiscard]] Script read_file(diagnostics::SourceManager&, const std::string& path, diagnostics::Diagnostics&);

/// A function that adds the text of a file to the sources. If this fails, it returns no value and sets `error` to the
/// cause.
using Loader = std::function<std::optional<diagnostics::SourceId>(const std::string& path, std::string& error)>;
/// Parses a file like the function above. `load` supplies the texts of the files, for example unsaved ones.
[[nodiscard]] Script read_file(diagnostics::SourceManager&, const std::string& path, diagnostics::Diagnostics&,
                               const Loader& load);

/// Prints a tree as text. FDR accepts the text, and `read` converts it back to an equal tree. Equal trees give equal
/// text. Lines have at most about 110 columns.
[[nodiscard]] std::string print(const Script&);
[[nodiscard]] std::string print(const ExprPtr&);
/// Prints a declaration without its comment and without a final line end.
[[nodiscard]] std::string print(const Decl&);

}  // namespace robochart::cspm
