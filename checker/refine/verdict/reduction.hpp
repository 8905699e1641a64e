// SPDX-License-Identifier: Apache-2.0
// Searches a system that has fewer states but the same answers (docs/search.md, "Confluent taus", "Deadlocks",
// "Symmetry"). A run that this search finds is converted to a shortest run of the whole system.
#pragma once

#include <functional>
#include <optional>

#include "checker/lts/transition_system.hpp"
#include "checker/refine/search/budget.hpp"
#include "checker/refine/verdict/findings.hpp"
#include "checker/refine/verdict/symbolic_stage.hpp"

namespace robochart::refine {

/// A query about a system, with the facts about the query that the reductions need.
struct SearchQuestion {
    /// Searches for a violation in a system. If `known` is not null, it points to a violation of the whole system, and
    /// the function searches for a shortest violation.
    std::function<std::optional<Violation>(lts::TransitionSystem&, Budget&, Statistics&, const Violation* known)>
        search;
    /// Returns whether the answer for a state is the same as for its images if automorphisms exchange these events. The
    /// argument contains exchanges of at least two events.
    std::function<bool(const lts::EventPermutation&)> indifferent;
    /// Whether to search for a shortest run in the whole system after the search has found a run in the reduced system.
    bool shortest = true;
    /// The confluent steps that the search may follow. If they are steps with any event, the search must only look for
    /// states without transitions.
    lts::Followed followed = lts::Followed::taus;
    /// The same question for the symbolic stage, or no value if the stage cannot decide this kind of question.
    std::optional<SymbolicQuestion> symbolic = std::nullopt;
};

/// Searches the reduced form of the system if the limits allow it and a reduced form exists. Otherwise searches the
/// system itself. The statistics describe this first search. The returned violation is always a violation of the system
/// itself. It is a shortest violation, unless a limit ends the search for a shortest violation.
[[nodiscard]] std::optional<Violation> search_reduced(lts::TransitionSystem& system, Budget& budget,
                                                      Statistics& statistics, const SearchQuestion& question);

/// Returns true if the limits allow static proofs and the rules of the system exclude cycles of taus.
[[nodiscard]] bool is_tau_acyclic(const lts::TransitionSystem& system, Budget& budget);

/// Returns the number of steps after which a run follows only taus (Search::first_violation).
[[nodiscard]] std::uint64_t events_until(const Violation* known);

}  // namespace robochart::refine
