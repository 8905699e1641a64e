// CSPM text to syntax tree and back.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "checker/cspm/syntax/syntax.hpp"
#include "diagnostics/diagnostic.hpp"

namespace robochart::cspm {

/// Reads a text. `include` declarations stay in the tree. Errors become diagnostics; the rest is still read.
[[nodiscard]] Script read(const diagnostics::SourceManager&, diagnostics::SourceId, diagnostics::Diagnostics&);
/// Reads a file and, in place, the files it includes (relative to the including file; each once a place; cycles are
/// errors, and so is more than a script can need: see reader.cpp).
[[nodiscard]] Script read_file(diagnostics::SourceManager&, const std::string& path, diagnostics::Diagnostics&);

/// Adds the text of a file to the sources. On failure returns nothing and sets `error` to the cause in words.
using Loader = std::function<std::optional<diagnostics::SourceId>(const std::string& path, std::string& error)>;
/// The same where the texts of some files are not those on disk.
[[nodiscard]] Script read_file(diagnostics::SourceManager&, const std::string& path, diagnostics::Diagnostics&,
                               const Loader& load);

/// Writes a tree as text that FDR accepts and `read` maps back to an equal tree. Stable; lines up to about 110 columns.
[[nodiscard]] std::string print(const Script&);
[[nodiscard]] std::string print(const ExprPtr&);
/// Without its comment, and without a line end behind it.
[[nodiscard]] std::string print(const Decl&);

}  // namespace robochart::cspm
