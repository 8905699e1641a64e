// What the server does with scripts in CSPM (LSP 3.17): notifications about their texts, findings, and the requests
// that are answered for them.
#pragma once

#include <string_view>

#include "lsp/cspm/scripts.hpp"
#include "lsp/workspace/session.hpp"

namespace robochart::lsp {

/// Applies a notification about a script. False if it is about something else, or not about scripts alone.
bool notify_script(const Session&, Scripts&, std::string_view method, View params);

/// Is a request about a script?
[[nodiscard]] bool asks_for_script(Scripts&, View params);
/// The answer to a request about a script; null for what is known of models alone.
[[nodiscard]] Json answer_for_script(const Session&, Scripts&, std::string_view method, View params);

/// Sends the findings about scripts and the files they include where they changed.
void publish_scripts(Session&, Scripts&);

}  // namespace robochart::lsp
