// What the two sides of a connection can do (LSP 3.17, initialize).
#pragma once

#include <string>
#include <vector>

#include "lsp/workspace/session.hpp"

namespace robochart::lsp {

/// The commands of lenses, with the document's URI and a name: of an assertion to be checked, of a component to be
/// drawn or to be stepped through. A client that has one says so: `initializationOptions.commands` lists it.
inline constexpr const char* check_command = "robochart.check";
inline constexpr const char* draw_command = "robochart.draw";
inline constexpr const char* step_command = "robochart.step";

/// What the parameters of `initialize` mean for us.
[[nodiscard]] Client client_of(View params);
/// The folders that the editor has open, as paths.
[[nodiscard]] std::vector<std::string> folders_of(View params);
/// The result of `initialize`.
[[nodiscard]] Json server_capabilities(const Client&);

}  // namespace robochart::lsp
