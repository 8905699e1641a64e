// SPDX-License-Identifier: Apache-2.0
// The server's functions for CSPM scripts (LSP 3.17): notifications about texts, findings, and requests.
#pragma once

#include <string_view>

#include "editors/server/cspm/scripts.hpp"
#include "editors/server/workspace/session.hpp"

namespace robochart::lsp {

/// Applies a notification about a script. Returns false if the notification is not about scripts, or not only about
/// scripts.
bool notify_script(const Session&, Scripts&, std::string_view method, View params);

/// True if a request is about a script.
[[nodiscard]] bool asks_for_script(Scripts&, View params);
/// The answer to a request about a script; null for requests that only models support.
[[nodiscard]] Json answer_for_script(const Session&, Scripts&, std::string_view method, View params);

/// Sends the findings about scripts and the files that they include, if they changed.
void publish_scripts(Session&, Scripts&);

}  // namespace robochart::lsp
