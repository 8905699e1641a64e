// SPDX-License-Identifier: Apache-2.0
// Names and words of a rule file by place, and its outline.
#pragma once

#include <optional>
#include <string>

#include "editors/server/sleec/rule_texts.hpp"

namespace robochart::lsp {

/// A word of a text.
struct RuleName {
    std::string text;
    Span span;
    Span declared;  ///< the place of its declaration in the file; unknown if there is none
};
/// The word at or directly before an offset.
[[nodiscard]] std::optional<RuleName> rule_name_at(const TextDocument&, const sleec::RuleFile&, std::uint32_t offset);
/// A description of the name: its declaration and the rules that mention it. For a keyword, its meaning. "" if the word
/// is unknown.
[[nodiscard]] std::string about_rule_name(const sleec::RuleFile&, const RuleName&, bool markdown);

/// The outline of definitions, rules, concerns and purposes, as DocumentSymbols, or as SymbolInformation for editors
/// that do not support DocumentSymbols.
[[nodiscard]] Json rule_outline(const TextDocument&, const sleec::RuleFile&, const Client&);

}  // namespace robochart::lsp
