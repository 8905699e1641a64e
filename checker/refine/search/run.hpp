// SPDX-License-Identifier: Apache-2.0
// Runs of a system as exact states, from which counterexamples are built.
#pragma once

#include <vector>

#include "checker/lts/transition_system.hpp"
#include "checker/process/term.hpp"

namespace robochart::refine {

/// An event and its target state.
struct RunStep {
    process::Event event;
    process::Event revealed;
    std::vector<lts::Word> state;  ///< the state reached
};

/// An initial state and the steps from it.
struct Run {
    std::vector<lts::Word> initial;
    std::vector<RunStep> steps;

    [[nodiscard]] const std::vector<lts::Word>& last_state() const {
        return steps.empty() ? initial : steps.back().state;
    }
    /// Returns the visible events and tick of the run.
    [[nodiscard]] std::vector<process::Event> trace() const {
        std::vector<process::Event> events;
        for (const RunStep& step : steps)
            if (step.event != process::tau) events.push_back(step.event);
        return events;
    }
};

}  // namespace robochart::refine
