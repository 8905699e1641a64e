// Questions about rules alone: whether a situation can arise in which not all can be obeyed, and whether one says
// nothing that another does not. docs/rules-language.md, "Questions about rules".
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "checker/refine/search/limits.hpp"
#include "diagnostics/budget.hpp"
#include "sleec/obligations/obligation.hpp"

namespace robochart::sleec {

enum class Answer : std::uint8_t { no, yes, not_decided };

/// One side of a conflict: an obligation with the trigger that opened it.
struct Side {
    std::size_t rule = 0;
    std::int64_t began = 0;  ///< second
    Valuation values;        ///< at the trigger
    Demand demand;           ///< the one that clashes, its window counted from `began`
};

/// A situation in which rules cannot all be obeyed: at `instant`, one of the demands `due` has to be fulfilled at last,
/// and each is forbidden by the side at the same place.
struct Conflict {
    std::vector<Side> due, forbidding;
    std::int64_t instant = 0;
    bool for_ever = false;  ///< nothing is due yet, but it never can be again
    bool endless = false;   ///< nothing is forbidden, but what is due calls for more at this instant, without end
    /// What else happens before, to keep the rules: second and event.
    std::vector<std::pair<std::int64_t, std::size_t>> besides;
};

/// The answer about one rule (and itself), two, or more.
struct ConflictAnswer {
    std::vector<std::size_t> rules;
    Answer conflict = Answer::no;
    std::optional<Conflict> example;
    std::string reason;  ///< not decided: why
    std::uint64_t states = 0;
};

struct AnalysisOptions {
    WithoutLimit without_limit = WithoutLimit::eventually;
    refine::Limits limits;
    diagnostics::Budget* budget = nullptr;
};

/// Whether these rules can come into conflict, and all of them have part in it: one with itself (by several triggers),
/// two, or more. `judged`: ascending.
[[nodiscard]] ConflictAnswer find_conflict(const CheckedRules& rules, std::vector<std::size_t> judged,
                                           const AnalysisOptions& options);
/// The smallest sets in conflict of the rules that are no assumptions. A duty with n alternatives for one last instant
/// is in conflict with at most n others, so that no more are asked about at once; beside these, rules that answer each
/// other within an instant, up to six, with one more that forbids what leads out of it. None is asked about three or
/// more of which fewer are in conflict.
void for_each_question(const CheckedRules& rules, const AnalysisOptions& options,
                       const std::function<void(const ConflictAnswer&)>& take);
/// Whether all that `rule` asks for, `by` asks for with the same trigger. Throws NotDecided.
[[nodiscard]] bool redundant(const CheckedRules& rules, std::size_t rule, std::size_t by,
                             const AnalysisOptions& options);
/// Whether a rule asks for nothing, whatever the measures are. Throws NotDecided.
[[nodiscard]] bool asks_for_nothing(const CheckedRules& rules, std::size_t rule, const AnalysisOptions& options);

}  // namespace robochart::sleec
