// SPDX-License-Identifier: Apache-2.0
// The server's functions for SLEEC rules (LSP 3.17): notifications about texts, findings, and requests.
#pragma once

#include <string_view>

#include "editors/server/sleec/rule_texts.hpp"

namespace robochart::lsp {

/// Applies a notification about a rule file. Returns false if it is about something else.
bool notify_rules(const Session&, RuleTexts&, std::string_view method, View params);

/// True if a request is about a rule file.
[[nodiscard]] bool asks_for_rules(RuleTexts&, View params);
/// The answer to a request about a rule file; null for requests that only models support.
[[nodiscard]] Json answer_for_rules(const Session&, RuleTexts&, std::string_view method, View params);

/// Sends the findings about open rule files, if they changed.
void publish_rules(Session&, RuleTexts&);

}  // namespace robochart::lsp
