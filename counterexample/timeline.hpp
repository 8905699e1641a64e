// SPDX-License-Identifier: Apache-2.0
// A run, moment by moment: the sequential components that move, the events that they perform, and the state of each
// component. Steps inside a compressed process, which the run of the whole process does not show, are separate moments.
#pragma once

#include <optional>
#include <vector>

#include "checker/process/behaviour.hpp"

namespace robochart::runs {

/// A sequential component of the process, as an index into Timeline::initial.
using Leaf = std::size_t;

struct Mover {
    Leaf leaf = 0;
    process::Event event = process::tau;  ///< the event of the component, also if the component hides it
};

struct Moment {
    std::size_t raw = 0;  ///< the step's number in the run; for a hidden step, that of the next visible step
    bool shown = true;    ///< false: a step inside a compressed process
    std::vector<Mover> movers;
    std::vector<std::optional<process::TermId>> leaves;  ///< each leaf's state afterwards; no value if it is absent
};

struct Timeline {
    std::vector<std::optional<process::TermId>> initial;
    std::vector<Moment> moments;
};

/// `steps`: the number of steps of the run to which the behaviour belongs.
[[nodiscard]] Timeline timeline_of(const process::Behaviour& behaviour, std::size_t steps);

}  // namespace robochart::runs
