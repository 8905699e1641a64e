// SPDX-License-Identifier: Apache-2.0
// Makes the outline of a script.
#pragma once

#include "editors/server/cspm/scripts.hpp"

namespace robochart::lsp {

/// Returns the declarations of a text in textual order, as DocumentSymbols, or as SymbolInformation for editors that do
/// not support DocumentSymbols.
[[nodiscard]] Json script_symbols(const ScriptReading&, SourceId, const std::string& uri, Encoding, bool hierarchical);

}  // namespace robochart::lsp
