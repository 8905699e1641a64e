// SPDX-License-Identifier: Apache-2.0
// Computes the refusals of a state. In FDR's models the environment cannot prevent termination (UCS 6.3, 9.2: P [] SKIP
// = P [> SKIP), so a state is stable if it has no tau and no tick. For refusals, a state with tick behaves as if a tau
// led from this state to SKIP, independently of its other offers. So it has the acceptance {✓}. No event follows tick:
// Ω has the empty acceptance.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "checker/process/term.hpp"

namespace robochart::refine {

/// The transitions of one state. `events` are its visible events and tick, ascending, without duplicates.
struct Offer {
    bool tau = false;
    process::EventSet events;
    bool branches = false;  ///< true if some event has several transitions

    [[nodiscard]] bool can_tick() const { return !events.empty() && events.front() == process::tick; }
    [[nodiscard]] bool is_empty() const { return !tau && events.empty(); }
};

/// Returns the least set of events that the state may accept, or no value if the state is unstable.
[[nodiscard]] inline std::optional<process::EventSet> acceptance(const Offer& offer) {
    if (offer.can_tick()) return process::EventSet{process::tick};
    if (offer.tau) return std::nullopt;
    return offer.events;
}

}  // namespace robochart::refine
