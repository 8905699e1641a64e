// What the server does with rules in SLEEC (LSP 3.17): notifications about their texts, findings, and the requests that
// are answered for them.
#pragma once

#include <string_view>

#include "lsp/sleec/rule_texts.hpp"

namespace robochart::lsp {

/// Applies a notification about a file of rules. False if it is about something else.
bool notify_rules(const Session&, RuleTexts&, std::string_view method, View params);

/// Is a request about a file of rules?
[[nodiscard]] bool asks_for_rules(RuleTexts&, View params);
/// The answer to a request about a file of rules; null for what is known of models alone.
[[nodiscard]] Json answer_for_rules(const Session&, RuleTexts&, std::string_view method, View params);

/// Sends the findings about open files of rules where they changed.
void publish_rules(Session&, RuleTexts&);

}  // namespace robochart::lsp
