// SPDX-License-Identifier: Apache-2.0
// Decides concerns and purposes (LEGOS). A concern must be impossible, and a purpose possible, if all rules are obeyed.
// Also decides whether a rule can be broken while all others are obeyed. See docs/rules-language.md, "Questions about
// rules".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "claims/sleec/analysis/conflicts.hpp"

namespace robochart::sleec {

/// An event of a history, and its time.
struct Happening {
    std::int64_t second = 0;
    std::size_t event = 0;
    Valuation values;
    bool named = false;  ///< true if the property is about this occurrence
};

/// The answer to the question whether some history in which the property occurs obeys all rules.
struct PropertyAnswer {
    Answer possible = Answer::no;
    std::vector<Happening> history;  ///< if possible, this history; then no event occurs, or its end repeats
    std::string reason;              ///< if not decided, the reason
    std::uint64_t states = 0;
};

/// Decides whether the property is possible if all rules of the file, including its assumptions, are obeyed.
[[nodiscard]] PropertyAnswer check_possible(const CheckedRules& rules, const CheckedProperty& property,
                                            const AnalysisOptions& options);

/// The answer to the question whether the other rules together imply a rule, so that no history obeys the others and
/// breaks this rule.
struct Implication {
    Answer implied = Answer::no;
    std::vector<std::size_t> by;  ///< implied: the rules that imply it; each one is necessary
    std::string reason;           ///< if not decided, the reason
};
/// Decides whether the other rules imply `rule`. If the other rules exclude its trigger, it is not reported as implied,
/// because the conflict is reported instead.
[[nodiscard]] Implication check_implied(const CheckedRules& rules, std::size_t rule, const AnalysisOptions& options);

/// Returns a set of rules that make the property impossible. Each of them is necessary. May be called only for an
/// impossible property. If the question without a rule cannot be decided, the rule is included.
[[nodiscard]] std::vector<std::size_t> excluding_rules(const CheckedRules& rules, const CheckedProperty& property,
                                                       const AnalysisOptions& options);

}  // namespace robochart::sleec
