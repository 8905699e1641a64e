// What a search has found in a compiled process, found again in the terms it was compiled from: the two engines check
// each other. A violation that the terms do not have is an internal error and throws std::logic_error.
#pragma once

#include "checker/refine/verdict/replay.hpp"
#include "checker/refine/verdict/verdict.hpp"

namespace robochart::refine {

/// A violation and the system whose states its runs have.
struct Confirmed {
    Violation violation;
    lts::TransitionSystem* system;
    bool by_terms = false;
};

/// Replays the violation in the system and, where it has one, in its reference; the violation returned is the
/// reference's own. `judge` is one of the confirm functions of replay.hpp, given the system whose states the runs have.
/// Where the reference needs more than its share of time the system's own replay has to do.
[[nodiscard]] Confirmed confirmed(lts::TransitionSystem& system, const Violation& violation, Budget& budget,
                                  const std::function<void(lts::TransitionSystem&, const Violation&, Budget&)>& judge);

/// A run of the reference with the same trace that ends in the same kind of state. Public for tests.
[[nodiscard]] Violation found_again(lts::TransitionSystem& system, lts::TransitionSystem& reference,
                                    const Violation& violation, Budget& budget);

}  // namespace robochart::refine
