// SPDX-License-Identifier: Apache-2.0
// Computes strategies from the graph alone.
#pragma once

#include "prism/markov/graph/graph.hpp"
#include "prism/markov/solve/solution.hpp"

namespace robochart::markov {

/// Returns the choices of these states that stay in the set.
[[nodiscard]] std::vector<bool> choices_within(const Model& model, const StateSet& set);

/// Sets choices in the states of the end component. With these choices, every state reaches the given choice (of one
/// state of the component) with probability 1.
void lead_to(const Graph& graph, const EndComponent& component, std::uint32_t choice,
             std::vector<std::uint32_t>& strategy);

/// Builds a strategy if one is requested. The default is the first choice of every state. If several calls set the
/// choice of a state, the last call applies.
class GraphStrategy {
public:
    GraphStrategy(const Graph& graph, const Precision& precision, std::vector<std::uint32_t>& strategy);

    /// In every state of the set, selects a choice that stays in the set.
    void stay_in_set(const StateSet& set);
    /// In every state of the set outside the goal, selects a choice with which the goal may be reached.
    void may_reach(const StateSet& goal, const StateSet& set);
    /// In every state of the set outside the goal, selects an admitted choice that stays in the set until the goal is
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
