// Completion in files of rules.
#pragma once

#include "lsp/sleec/rule_texts.hpp"

namespace robochart::lsp {

/// The names and words that fit behind those in front of the offset.
[[nodiscard]] Json rule_completion(const RuleText&, const sleec::RuleFile&, std::uint32_t offset, Encoding);

}  // namespace robochart::lsp
