// SPDX-License-Identifier: Apache-2.0
// Completion in SLEEC rule files.
#pragma once

#include "editors/server/sleec/rule_texts.hpp"

namespace robochart::lsp {

/// The names and words that may follow the tokens before the offset. `models`: those beside the rules, whose states
/// rules name; null: there are none.
[[nodiscard]] Json rule_completion(const TextDocument&, const sleec::RuleFile&, const ClaimedModels* models,
                                   std::uint32_t offset, Encoding);

}  // namespace robochart::lsp
