// SPDX-License-Identifier: Apache-2.0
// Decides questions about rules without a model: whether the rules can be in conflict, so that not all of them can be
// obeyed, and whether a rule is redundant (docs/rules-language.md, "Questions about rules").
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "checker/refine/search/limits.hpp"
#include "claims/sleec/obligations/obligation.hpp"

namespace robochart::sleec {

enum class Answer : std::uint8_t { no, yes, not_decided };

/// One side of a conflict: an obligation, and the trigger that opened it.
struct Side {
    std::size_t rule = 0;
    std::int64_t began = 0;  ///< the second of the trigger
    Valuation values;        ///< the values at the trigger
    Demand demand;           ///< the clashing demand; its window is counted from `began`
};

/// A situation in which the rules cannot all be obeyed. At `instant`, one of the demands `due` must be fulfilled, but
/// each is forbidden by the side with the same index.
struct Conflict {
    std::vector<Side> due, forbidding;
    std::int64_t instant = 0;
    bool for_ever = false;  ///< true if no demand is due yet, but the demanded event is forbidden forever
    bool endless = false;   ///< no event is forbidden, but every due event triggers further demands at this instant,
                            ///< without end
    /// Other events before the conflict that are needed to obey the rules, as pairs of second and event.
    std::vector<std::pair<std::int64_t, std::size_t>> besides;
};

/// The answer about a single rule, a pair, or a larger set.
struct ConflictAnswer {
    std::vector<std::size_t> rules;
    Answer conflict = Answer::no;
    std::optional<Conflict> example;
    std::string reason;  ///< the reason why the question is not decided
    std::uint64_t states = 0;
};

struct AnalysisOptions {
    WithoutLimit without_limit = WithoutLimit::eventually;
    refine::Limits limits;
    diagnostics::Budget* budget = nullptr;
};

/// Decides whether there is a conflict in which all of these rules take part. A single rule may be in conflict if it
/// has several triggers. The numbers in `judged` are ascending.
[[nodiscard]] ConflictAnswer find_conflict(const CheckedRules& rules, std::vector<std::size_t> judged,
                                           const AnalysisOptions& options);
/// Searches the smallest conflicting sets of rules that are not assumptions. A duty with n alternatives at one last
/// instant conflicts with at most n other rules, so larger sets need not be checked. In addition, sets of up to six
/// rules that trigger each other within an instant are checked. They are also checked with one more rule that forbids
/// an event demanded in the set. Sets of three or more rules are not checked if a subset is in conflict.
void for_each_question(const CheckedRules& rules, const AnalysisOptions& options,
                       const std::function<void(const ConflictAnswer&)>& take);
/// Returns true if `by` demands everything that `rule` demands for the same trigger. Throws NotDecided.
[[nodiscard]] bool is_redundant(const CheckedRules& rules, std::size_t rule, std::size_t by,
                                const AnalysisOptions& options);
/// True if a rule makes no demand for any values of the measures. Throws NotDecided.
[[nodiscard]] bool makes_no_demand(const CheckedRules& rules, std::size_t rule, const AnalysisOptions& options);

}  // namespace robochart::sleec
