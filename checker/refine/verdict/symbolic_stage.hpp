// SPDX-License-Identifier: Apache-2.0
// The interface to a search that represents sets of states instead of single states (checker/symbolic). It decides
// questions that the explicit search has not decided for some time (docs/search.md, "Decision diagrams").
#pragma once

#include <chrono>
#include <optional>

#include "checker/refine/search/budget.hpp"
#include "checker/refine/verdict/findings.hpp"
#include "checker/refine/verdict/verdict.hpp"

namespace robochart::refine {

/// What must not be reachable.
struct SymbolicQuestion {
    bool deadlock = false;    ///< a state without transitions
    bool divergence = false;  ///< a cycle of taus; with a specification, only before it diverges
    /// If not null: an event that this process does not allow after the same trace and, except in the traces model, a
    /// refusal. Runs on which the specification diverges are ignored in the failures-divergences model.
    lts::TransitionSystem* specification = nullptr;
    Model model = Model::traces;  ///< with a specification
    friend bool operator==(const SymbolicQuestion&, const SymbolicQuestion&) = default;
};

class SymbolicStage {
public:
    SymbolicStage() = default;
    SymbolicStage(const SymbolicStage&) = delete;
    SymbolicStage& operator=(const SymbolicStage&) = delete;
    virtual ~SymbolicStage() = default;
    /// The search tries the stage when it has used this much CPU time.
    [[nodiscard]] virtual std::chrono::duration<double> delay() const = 0;
    /// Returns the findings of a complete exploration. No other work may use the specification meanwhile. No value if
    /// the system has no rules, or if the stage reaches its bounds. A violation is a run of the system, which the
    /// caller confirms. Throws LimitReached if the budget's limits are reached.
    [[nodiscard]] virtual std::optional<Findings> decide(lts::TransitionSystem& system,
                                                         const SymbolicQuestion& question, Budget& budget) = 0;
};

}  // namespace robochart::refine
