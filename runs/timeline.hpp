// A run taken apart, moment by moment: which sequential components move, by which of their own events, and where each
// of them is. Steps inside a compressed process, which the run of the whole does not show, are moments of their own.
#pragma once

#include <optional>
#include <vector>

#include "checker/process/behaviour.hpp"

namespace robochart::runs {

/// A sequential component of the process by its place in Timeline::initial.
using Leaf = std::size_t;

struct Mover {
    Leaf leaf = 0;
    process::Event event = process::tau;  ///< its own; for what it hides itself, the hidden event
};

struct Moment {
    std::size_t raw = 0;  ///< the step of the run that it is, or in front of which (at the end: behind which) it is
    bool shown = true;    ///< false: a step inside a compressed process
    std::vector<Mover> movers;
    std::vector<std::optional<process::TermId>> leaves;  ///< where each is behind it; none: it is not there
};

struct Timeline {
    std::vector<std::optional<process::TermId>> initial;
    std::vector<Moment> moments;
};

/// `steps`: of the run that the behaviour is of.
[[nodiscard]] Timeline timeline(const process::Behaviour& behaviour, std::size_t steps);

}  // namespace robochart::runs
