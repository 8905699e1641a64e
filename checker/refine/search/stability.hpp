// What a state can refuse. Termination is autonomous in FDR's models (UCS 6.3, 9.2: P [] SKIP = P [> SKIP): a state is
// stable if it has no tau and no tick; a state with tick behaves for refusals as if it could move to SKIP, whatever
// else it offers, and so has the acceptance {✓}. After tick nothing is possible: Ω has the empty acceptance.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "checker/process/term.hpp"

namespace robochart::refine {

/// What one state can do. `events` are its visible events and tick, ascending, without repetitions.
struct Offer {
    bool tau = false;
    process::EventSet events;
    bool branches = false;  ///< some event is offered more than once

    [[nodiscard]] bool ticks() const { return !events.empty() && events.front() == process::tick; }
    [[nodiscard]] bool nothing() const { return !tau && events.empty(); }
};

/// The least set that the state may insist on; none if it is unstable.
[[nodiscard]] inline std::optional<process::EventSet> acceptance(const Offer& offer) {
    if (offer.ticks()) return process::EventSet{process::tick};
    if (offer.tau) return std::nullopt;
    return offer.events;
}

}  // namespace robochart::refine
