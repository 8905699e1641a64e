// Whether an event can come without end: the question that a duty without limit asks of a finite graph.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "checker/lts/graph.hpp"

namespace robochart::sleec {

/// A step of a run.
struct EndlessStep {
    lts::Event event = 0;
    lts::Event revealed = 0;  ///< of a hidden step, the event that was hidden
};

/// A run in which an event comes without end: steps from the initial state, then those that are repeated.
struct EndlessRun {
    std::vector<EndlessStep> steps, loop;
};

/// A run with the event infinitely often; nothing if there is none. There is one iff a strongly connected component of
/// what is reachable has the event on an edge inside. `poll` is called once a state, with their number, and may throw.
[[nodiscard]] std::optional<EndlessRun> endless_run(lts::TransitionSystem& system, lts::Event event,
                                                    const std::function<void(std::size_t states)>& poll);

}  // namespace robochart::sleec
