// SPDX-License-Identifier: Apache-2.0
// A run, moment by moment: which sequential components move, by which of their own events, and the state of each of
// them. Steps inside a compressed process, which the run of the whole process does not show, are separate moments.
#pragma once

#include <optional>
#include <vector>

#include "checker/process/behaviour.hpp"

namespace robochart::runs {

/// A sequential component of the process, as an index into Timeline::initial.
using Leaf = std::size_t;

struct Mover {
    Leaf leaf = 0;
    process::Event event = process::tau;  ///< its own; for an event that it hides, the hidden event
};

struct Moment {
    std::size_t raw = 0;  ///< the step of the run that it is or, for a hidden step, the next one
    bool shown = true;    ///< false: a step inside a compressed process
    std::vector<Mover> movers;
    std::vector<std::optional<process::TermId>> leaves;  ///< the state of each leaf after it; no value: the leaf does
                                                         ///< not exist
};

struct Timeline {
    std::vector<std::optional<process::TermId>> initial;
    std::vector<Moment> moments;
};

/// `steps`: the number of steps of the run to which the behaviour belongs.
[[nodiscard]] Timeline timeline(const process::Behaviour& behaviour, std::size_t steps);

}  // namespace robochart::runs
