// SPDX-License-Identifier: Apache-2.0
// Searches of a system with fewer states (docs/search.md, "Confluent taus", "Symmetry"). Their results are converted to
// shortest runs of the whole system.
#pragma once

#include <functional>
#include <optional>

#include "checker/lts/transition_system.hpp"
#include "checker/refine/search/budget.hpp"
#include "checker/refine/verdict/findings.hpp"

namespace robochart::refine {

/// A query about a system.
struct SearchQuestion {
    /// Searches a violation in a system. `known`: the whole system is known to have this one, and a shortest one is
    /// wanted.
    std::function<std::optional<Violation>(lts::TransitionSystem&, Budget&, Statistics&, const Violation* known)>
        search;
    /// Whether a state has the same answer as its images if automorphisms exchange these events. Called with exchanges
    /// of at least two events.
    std::function<bool(const lts::EventPermutation&)> indifferent;
    /// Whether a shortest run is searched in the whole system after one has been found in its reduced form.
    bool shortest = true;
};

/// The result of the query's search in the system or, if limits allow it and there is one, in its reduced form;
/// statistics are those of that search. In both cases the violation is one of the system, and a shortest one unless a
/// limit ends the search for it.
[[nodiscard]] std::optional<Violation> search_reduced(lts::TransitionSystem& system, Budget& budget,
                                                      Statistics& statistics, const SearchQuestion& question);

/// The number of steps of a run for which events are followed (Search::first_violation).
[[nodiscard]] std::uint64_t events_until(const Violation* known);

}  // namespace robochart::refine
