// SPDX-License-Identifier: Apache-2.0
// Stores the states of a process with the names of its hidden events, and compares processes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/lts/graph.hpp"
#include "checker/lts/transition_system.hpp"

namespace robochart::probability {

/// A transition. For a tau, `revealed` is the hidden event.
struct Step {
    lts::Event event;
    lts::Event revealed;
    lts::StateIndex target;
};

/// All reachable states in breadth-first order.
class Exploration {
public:
    /// Throws LimitReached if there are more than `most_states`. Polls the budget for each state.
    Exploration(lts::TransitionSystem& system, std::uint64_t most_states, diagnostics::Pollable& budget);

    [[nodiscard]] std::size_t size() const { return first_.size() - 1; }
    [[nodiscard]] lts::StateView state(lts::StateIndex index) const { return states_[index]; }
    [[nodiscard]] std::span<const Step> steps_from(lts::StateIndex index) const {
        return std::span(steps_).subspan(first_[index], first_[index + 1U] - first_[index]);
    }

private:
    class Sink;
    lts::StateStore states_;
    std::vector<std::uint64_t> first_{0};
    std::vector<Step> steps_;
};

/// Returns true if the initial states of both systems are divergence-sensitive branching bisimilar, with every hidden
/// event as a tau. `events` is the event table of `explored`.
[[nodiscard]] bool are_bisimilar(const Exploration& explored, lts::EventTable& events, lts::TransitionSystem& other,
                                 diagnostics::Pollable& budget);

}  // namespace robochart::probability
