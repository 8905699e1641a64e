// SPDX-License-Identifier: Apache-2.0
// Divides a run into moments. A moment contains the sequential components that move, the events that they perform, and
// the state of each component. Steps inside a compressed process, which the run of the whole process does not show, are
// separate moments.
#pragma once

#include <optional>
#include <vector>

#include "checker/process/behaviour.hpp"

namespace robochart::runs {

/// A sequential component of the process, as an index into Timeline::initial.
using Leaf = std::size_t;

struct Mover {
    Leaf leaf = 0;
    process::Event event = process::tau;  ///< the component's own event, even if the component hides it
};

struct Moment {
    std::size_t raw = 0;  ///< number of the step in the run; for a hidden step, that of the next visible step
    bool shown = true;    ///< false for a step inside a compressed process
    std::vector<Mover> movers;
    /// By leaf: its state after the moment; no value if it does not exist.
    std::vector<std::optional<process::TermId>> leaves;
};

struct Timeline {
    std::vector<std::optional<process::TermId>> initial;
    std::vector<Moment> moments;
};

/// Returns the timeline of a run. `steps`: the number of steps of the run to which the behaviour belongs.
[[nodiscard]] Timeline timeline_of(const process::Behaviour& behaviour, std::size_t steps);

}  // namespace robochart::runs
