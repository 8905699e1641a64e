// SPDX-License-Identifier: Apache-2.0
// The server's functions for scenarios, mappings and swarms (LSP 3.17): notifications about texts, findings, and
// completion of keywords.
#pragma once

#include <string_view>

#include "editors/server/plain/plain_texts.hpp"

namespace robochart::lsp {

/// Applies a notification about a scenario, a mapping or a swarm. Returns false if the notification is about another
/// text.
bool notify_plain(const Session&, PlainTexts&, std::string_view method, View params);

/// True if a request is about a scenario, a mapping or a swarm.
[[nodiscard]] bool asks_for_plain(PlainTexts&, View params);
/// The answer to the request; null for requests that only models support.
[[nodiscard]] Json answer_for_plain(const Session&, PlainTexts&, std::string_view method, View params);

/// Sends the findings about the open texts, if they changed.
void publish_plain(Session&, PlainTexts&);

}  // namespace robochart::lsp
