// What the two sides of a connection can do (LSP 3.17, initialize).
#pragma once

#include <string>
#include <vector>

#include "lsp/workspace/session.hpp"

namespace robochart::lsp {

/// The command of the lenses above assertions, with the document's URI and the assertion's name. A client that has it
/// says so: `initializationOptions.commands` lists it.
inline constexpr const char* check_command = "robochart.check";

/// What the parameters of `initialize` mean for us.
[[nodiscard]] Client client_of(View params);
/// The folders that the editor has open, as paths.
[[nodiscard]] std::vector<std::string> folders_of(View params);
/// The result of `initialize`.
[[nodiscard]] Json server_capabilities(const Client&);

}  // namespace robochart::lsp
