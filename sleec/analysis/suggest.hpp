// A smallest change that removes a conflict: `unless` at the end of one rule, or of two. Only what a new search has
// confirmed is suggested.
#pragma once

#include <string>
#include <vector>

#include "sleec/analysis/conflicts.hpp"

namespace robochart::sleec {

/// `unless ...` to be written behind the response of a rule.
struct Suggestion {
    std::size_t rule = 0;
    std::string text;  ///< "unless near"
};

/// Defeaters with which the rules of a conflict are in conflict no more, and each still asks for something: one measure
/// or one event behind one rule, or else behind two rules the trigger of the other. Nothing where none of these helps,
/// or where that is not decided.
[[nodiscard]] std::vector<Suggestion> suggest(const CheckedRules& rules, const std::vector<std::size_t>& in_conflict,
                                              const AnalysisOptions& options);

}  // namespace robochart::sleec
