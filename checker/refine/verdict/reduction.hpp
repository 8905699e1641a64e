// Searches of a system with fewer states (docs/search.md, "Confluent taus"). What they find is made a run of the whole
// system, and a shortest one.
#pragma once

#include <functional>
#include <optional>

#include "checker/lts/transition_system.hpp"
#include "checker/refine/search/budget.hpp"
#include "checker/refine/verdict/findings.hpp"

namespace robochart::refine {

/// Looks for a violation in a system. `known`: the whole system is known to have this one, and a shortest one is
/// wanted.
using ViolationSearch =
    std::function<std::optional<Violation>(lts::TransitionSystem&, Budget&, Statistics&, const Violation* known)>;

/// What the search finds in the system, or where limits allow it and there is one, in its reduced form; statistics are
/// those of that search. The violation is one of the system in both cases, and a shortest one, unless a limit ends the
/// search for it.
[[nodiscard]] std::optional<Violation> search_reduced(lts::TransitionSystem& system, Budget& budget,
                                                      Statistics& statistics, const ViolationSearch& search);

/// How many steps of a run may be events (Search::first_violation).
[[nodiscard]] std::uint64_t events_until(const Violation* known);

/// A run of the reduced system as one of the system that it was made from. Public for tests.
[[nodiscard]] Run run_of_whole(lts::TransitionSystem& system, lts::ReducedSystem& reduced, const Run& run);

}  // namespace robochart::refine
