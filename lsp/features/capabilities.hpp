// What the two sides of a connection can do (LSP 3.17, initialize).
#pragma once

#include <string>
#include <vector>

#include "lsp/workspace/session.hpp"

namespace robochart::lsp {

/// What the editor's capabilities mean for us.
[[nodiscard]] Client client_of(View capabilities);
/// The folders that the editor has open, as paths.
[[nodiscard]] std::vector<std::string> folders_of(View params);
/// The result of `initialize`.
[[nodiscard]] Json server_capabilities(const Client&);

}  // namespace robochart::lsp
