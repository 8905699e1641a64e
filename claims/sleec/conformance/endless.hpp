// SPDX-License-Identifier: Apache-2.0
// Decides whether an event can occur infinitely often in a finite graph. Duties without limit need this answer.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "checker/lts/graph.hpp"

namespace robochart::sleec {

/// A step of a run.
struct EndlessStep {
    lts::Event event = 0;
    lts::Event revealed = 0;  ///< for a hidden step, the hidden event
};

/// A run in which an event occurs infinitely often: steps from the initial state, then the repeated steps.
struct EndlessRun {
    std::vector<EndlessStep> steps, loop;
};

/// Returns a run in which the event occurs infinitely often; no value if there is none. Such a run exists iff a
/// strongly connected component of the reachable states contains an edge with the event. `on_state`: see lts::explore.
[[nodiscard]] std::optional<EndlessRun> endless_run(lts::TransitionSystem& system, lts::Event event,
                                                    const std::function<void(std::size_t states)>& on_state);

}  // namespace robochart::sleec
