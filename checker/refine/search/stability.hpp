// SPDX-License-Identifier: Apache-2.0
// The refusals of a state. Termination is autonomous in FDR's models (UCS 6.3, 9.2: P [] SKIP = P [> SKIP): a state is
// stable if it has no tau and no tick. For refusals, a state with tick behaves as if a tau led from it to SKIP,
// independently of its other offers. So it has the acceptance {✓}. After tick nothing is possible: Ω has the empty
// acceptance.
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
    bool branches = false;  ///< some event is offered more than once

    [[nodiscard]] bool can_tick() const { return !events.empty() && events.front() == process::tick; }
    [[nodiscard]] bool is_empty() const { return !tau && events.empty(); }
};

/// The least set that the state may accept; no value if it is unstable.
[[nodiscard]] inline std::optional<process::EventSet> acceptance(const Offer& offer) {
    if (offer.can_tick()) return process::EventSet{process::tick};
    if (offer.tau) return std::nullopt;
    return offer.events;
}

}  // namespace robochart::refine
