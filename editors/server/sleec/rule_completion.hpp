// SPDX-License-Identifier: Apache-2.0
// Completes text in SLEEC rule files.
#pragma once

#include "editors/server/sleec/rule_texts.hpp"

namespace robochart::lsp {

/// Returns the names and words that may follow the tokens before the offset. `models` are the models in the folder of
/// the rules, whose states rules may name; null if there are none.
[[nodiscard]] Json rule_completion(const TextDocument&, const sleec::RuleFile&, const ClaimedModels* models,
                                   std::uint32_t offset, Encoding);

}  // namespace robochart::lsp
