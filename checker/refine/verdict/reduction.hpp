// Searches of a system with fewer states (docs/search.md, "Confluent taus", "Symmetry"). What they find is made a run
// of the whole system, and a shortest one.
#pragma once

#include <functional>
#include <optional>

#include "checker/lts/transition_system.hpp"
#include "checker/refine/search/budget.hpp"
#include "checker/refine/verdict/findings.hpp"

namespace robochart::refine {

/// A question about a system.
struct SearchQuestion {
    /// Looks for a violation in a system. `known`: the whole system is known to have this one, and a shortest one is
    /// wanted.
    std::function<std::optional<Violation>(lts::TransitionSystem&, Budget&, Statistics&, const Violation* known)>
        search;
    /// Whether a state has the same answer as its images where automorphisms exchange these events. Asked for exchanges
    /// of at least two events.
    std::function<bool(const lts::EventPermutation&)> indifferent;
    /// Whether a shortest run is looked for in the whole system after one has been found in its reduced form.
    bool shortest = true;
};

/// What the question's search finds in the system, or where limits allow it and there is one, in its reduced form;
/// statistics are those of that search. The violation is one of the system in both cases, and a shortest one, unless a
/// limit ends the search for it.
[[nodiscard]] std::optional<Violation> search_reduced(lts::TransitionSystem& system, Budget& budget,
                                                      Statistics& statistics, const SearchQuestion& question);

/// How many steps of a run may be events (Search::first_violation).
[[nodiscard]] std::uint64_t events_until(const Violation* known);

}  // namespace robochart::refine
