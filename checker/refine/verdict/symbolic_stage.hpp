// SPDX-License-Identifier: Apache-2.0
// The interface to a search that represents sets of states instead of single states (checker/symbolic). Such a search
// decides questions that the explicit search has not decided after some time (docs/search.md, "Decision diagrams").
#pragma once

#include <chrono>
#include <optional>

#include "checker/refine/search/budget.hpp"
#include "checker/refine/verdict/findings.hpp"
#include "checker/refine/verdict/verdict.hpp"

namespace robochart::refine {

/// Describes what must not be reachable.
struct SymbolicQuestion {
    bool deadlock = false;    ///< a state without transitions
    bool divergence = false;  ///< a cycle of taus; with a specification, only a cycle before the specification diverges
    /// If this is not null, two faults must not be reachable. The first fault is an event that the specification does
    /// not allow after the same trace. The second fault (except in the traces model) is a refusal that the
    /// specification does not allow. In the failures-divergences model, the stage ignores runs on which the
    /// specification diverges.
    lts::TransitionSystem* specification = nullptr;
    Model model = Model::traces;  ///< used with a specification
    friend bool operator==(const SymbolicQuestion&, const SymbolicQuestion&) = default;
};

class SymbolicStage {
public:
    SymbolicStage() = default;
    SymbolicStage(const SymbolicStage&) = delete;
    SymbolicStage& operator=(const SymbolicStage&) = delete;
    virtual ~SymbolicStage() = default;
    /// Returns how much CPU time the search uses before it tries the stage.
    [[nodiscard]] virtual std::chrono::duration<double> delay() const = 0;
    /// Returns the findings of a complete exploration. Meanwhile no other work may use the specification. Returns no
    /// value if the system has no rules, or if the stage reaches its bounds. A violation is a run of the system, which
    /// the caller must confirm. Throws LimitReached if the limits of the budget are reached.
    [[nodiscard]] virtual std::optional<Findings> decide(lts::TransitionSystem& system,
                                                         const SymbolicQuestion& question, Budget& budget) = 0;
};

}  // namespace robochart::refine
