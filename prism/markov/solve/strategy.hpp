// SPDX-License-Identifier: Apache-2.0
// Strategies that follow from the graph.
#pragma once

#include "prism/markov/graph/graph.hpp"
#include "prism/markov/solve/solution.hpp"

namespace robochart::markov {

/// The choices of these states that stay in the set.
[[nodiscard]] std::vector<bool> choices_within(const Model& model, const StateSet& set);

/// Sets choices in the states of the end component that lead with probability 1 to this choice of one of its states.
void lead_to(const Graph& graph, const EndComponent& component, std::uint32_t choice,
             std::vector<std::uint32_t>& strategy);

/// Writes a strategy if one is requested. The default is the first choice of every state. If several functions set the
/// choice of a state, the last call applies.
class GraphStrategy {
public:
    GraphStrategy(const Graph& graph, const Precision& precision, std::vector<std::uint32_t>& strategy);

    /// Sets, in the states of the set, choices that stay in it.
    void stay_in_set(const StateSet& set);
    /// Sets, in the states of the set outside the goal, choices with which the goal may be reached.
    void may_reach(const StateSet& goal, const StateSet& set);
    /// Sets, in the states of the set outside the goal, admitted choices that stay in the set until the goal is
    /// reached.
    void reach_goal(const StateSet& goal, const StateSet& set, const std::vector<bool>& admitted);
    /// Makes the strategy take this choice infinitely often in the end component.
    void repeat_choice(const EndComponent& component, std::uint32_t choice);

private:
    void go_back(const StateSet& goal, const StateSet& set, const std::vector<bool>& admitted);

    const Graph& graph_;
    const bool requested_;
    std::vector<std::uint32_t>& strategy_;
};

}  // namespace robochart::markov
