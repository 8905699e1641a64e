// SPDX-License-Identifier: Apache-2.0
// Negotiates the capabilities of client and server (LSP 3.17, initialize).
#pragma once

#include <string>
#include <vector>

#include "editors/server/documents/session.hpp"

namespace robochart::lsp {

/// The commands of code lenses. Their arguments are the document's URI and the name of an assertion to check, or of a
/// component to draw or to step through. A client lists the commands that it supports in
/// `initializationOptions.commands`.
inline constexpr const char* check_command = "robochart.check";
inline constexpr const char* draw_command = "robochart.draw";
inline constexpr const char* step_command = "robochart.step";

/// Reads the client's capabilities from the parameters of `initialize`.
[[nodiscard]] Client client_of(View params);
/// Returns the paths of the folders that the editor has open.
[[nodiscard]] std::vector<std::string> folders_of(View params);
/// Returns the result of `initialize`.
[[nodiscard]] Json server_capabilities(const Client&);
/// Returns the request that makes the editor report changes of files that are not open.
[[nodiscard]] Json watch_request();

}  // namespace robochart::lsp
