// SPDX-License-Identifier: Apache-2.0
// Represents a run of a system by its states and events. Counterexamples are built from these runs.
#pragma once

#include <vector>

#include "checker/lts/transition_system.hpp"
#include "checker/process/term.hpp"

namespace robochart::refine {

/// An event and its target state.
struct RunStep {
    process::Event event;
    process::Event revealed;
    std::vector<lts::Word> state;  ///< the state after the event
};

/// An initial state, and the steps from this state.
struct Run {
    std::vector<lts::Word> initial;
    std::vector<RunStep> steps;

    [[nodiscard]] const std::vector<lts::Word>& last_state() const {
        return steps.empty() ? initial : steps.back().state;
    }
    /// Returns the visible events and ticks of the run.
    [[nodiscard]] std::vector<process::Event> trace() const {
        std::vector<process::Event> events;
        for (const RunStep& step : steps)
            if (step.event != process::tau) events.push_back(step.event);
        return events;
    }
};

}  // namespace robochart::refine
