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
    bool named = false;  ///< true: the property is about this occurrence
};

/// True if some history in which the property occurs obeys all rules.
struct PropertyAnswer {
    Answer possible = Answer::no;
    std::vector<Happening> history;  ///< possible: such a history; after it no event occurs, or its end repeats
    std::string reason;              ///< not decided: the reason
    std::uint64_t states = 0;
};

/// Decides whether the property is possible if all rules of the file, including its assumptions, are obeyed.
[[nodiscard]] PropertyAnswer check_possible(const CheckedRules& rules, const CheckedProperty& property,
                                            const AnalysisOptions& options);

/// True if the other rules together imply `rule`: no history obeys them and breaks it.
struct Implication {
    Answer implied = Answer::no;
    std::vector<std::size_t> by;  ///< implied: rules that imply it, all of them needed
    std::string reason;           ///< not decided: the reason
};
/// A rule whose trigger the other rules exclude is not reported as implied, because the conflict is reported.
[[nodiscard]] Implication check_implied(const CheckedRules& rules, std::size_t rule, const AnalysisOptions& options);

/// Returns a set of rules that make the property impossible and are all needed for this. May be called only for an
/// impossible property. A rule counts as needed if its removal cannot be decided.
[[nodiscard]] std::vector<std::size_t> excluding_rules(const CheckedRules& rules, const CheckedProperty& property,
                                                       const AnalysisOptions& options);

}  // namespace robochart::sleec
