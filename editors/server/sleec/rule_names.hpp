// SPDX-License-Identifier: Apache-2.0
// Finds the names and words at places in a rule file, and makes its outline.
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
/// Returns the word at or directly before an offset.
[[nodiscard]] std::optional<RuleName> rule_name_at(const TextDocument&, const sleec::RuleFile&, std::uint32_t offset);
/// Describes a name by its declaration and the rules that mention it, and a keyword by its meaning. Returns "" if the
/// word is unknown.
[[nodiscard]] std::string about_rule_name(const sleec::RuleFile&, const RuleName&, bool markdown);

/// Returns the outline of definitions, rules, concerns and purposes, as DocumentSymbols, or as SymbolInformation for
/// editors that do not support DocumentSymbols.
[[nodiscard]] Json rule_outline(const TextDocument&, const sleec::RuleFile&, const Client&);

}  // namespace robochart::lsp
