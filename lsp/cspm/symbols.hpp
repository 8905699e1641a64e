// The outline of a script.
#pragma once

#include "lsp/cspm/scripts.hpp"

namespace robochart::lsp {

/// What a text declares, in its order: DocumentSymbols, or SymbolInformation for editors that know only that.
[[nodiscard]] Json script_symbols(const ScriptReading&, SourceId, const std::string& uri, Encoding, bool hierarchical);

}  // namespace robochart::lsp
