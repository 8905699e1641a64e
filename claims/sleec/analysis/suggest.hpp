// SPDX-License-Identifier: Apache-2.0
// Suggests a smallest change that removes a conflict: an `unless` at the end of one rule, or of two rules. A change is
// suggested only if a new search confirms it.
#pragma once

#include <string>
#include <vector>

#include "claims/sleec/analysis/conflicts.hpp"

namespace robochart::sleec {

/// A suggested `unless ...`, to be added after the response of a rule.
struct Suggestion {
    std::size_t rule = 0;
    std::string text;  ///< "unless near"
};

/// Finds defeaters with which the rules are no longer in conflict and each rule still demands something. The first
/// candidates are a condition on one measure, or one event, for one rule. If none of these removes the conflict, the
/// next candidate gives each of two rules the trigger of the other as its defeater. The result is empty if no defeater
/// removes the conflict, or if this is not decided.
[[nodiscard]] std::vector<Suggestion> suggest_defeaters(const CheckedRules& rules,
                                                        const std::vector<std::size_t>& in_conflict,
                                                        const AnalysisOptions& options);

}  // namespace robochart::sleec
