// What the server does with scenarios, mappings and swarms (LSP 3.17): notifications about their texts, findings, and
// completion of keywords.
#pragma once

#include <string_view>

#include "lsp/plain/plain_texts.hpp"

namespace robochart::lsp {

/// Applies a notification about one of these texts. False if it is about something else.
bool notify_plain(const Session&, PlainTexts&, std::string_view method, View params);

/// Is a request about one of them?
[[nodiscard]] bool asks_for_plain(PlainTexts&, View params);
/// The answer to it; null for what is known of models alone.
[[nodiscard]] Json answer_for_plain(const Session&, PlainTexts&, std::string_view method, View params);

/// Sends the findings about the open texts where they changed.
void publish_plain(Session&, PlainTexts&);

}  // namespace robochart::lsp
