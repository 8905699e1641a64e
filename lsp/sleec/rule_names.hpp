// Names and words of a file of rules by place, and its outline.
#pragma once

#include <optional>
#include <string>

#include "lsp/sleec/rule_texts.hpp"

namespace robochart::lsp {

/// A word of a text.
struct RuleName {
    std::string text;
    Span span;
    Span declared;  ///< where the file declares it; unknown: it does not
};
/// The word at or directly before an offset.
[[nodiscard]] std::optional<RuleName> rule_name_at(const RuleText&, const sleec::RuleFile&, std::uint32_t offset);
/// What it is: its declaration, the rules that speak of it; of a word of the language, what it means. "" if nothing is
/// known.
[[nodiscard]] std::string about_rule_name(const sleec::RuleFile&, const RuleName&, bool markdown);

/// Definitions, rules, concerns and purposes: DocumentSymbols, or SymbolInformation for editors that know only that.
[[nodiscard]] Json rule_outline(const RuleText&, const sleec::RuleFile&, const Client&);

}  // namespace robochart::lsp
