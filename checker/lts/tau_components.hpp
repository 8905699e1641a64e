// SPDX-License-Identifier: Apache-2.0
// Computes the strongly connected components of a graph's taus. Contracts each of them to one state.
#pragma once

#include <vector>

#include "checker/lts/graph.hpp"

namespace robochart::lts {

struct TauComponents {
    std::vector<StateIndex> component;  ///< by state; a tau between components leads to a lower number
    std::vector<bool> cyclic;           ///< by component: true if its states can perform taus forever inside it
};

[[nodiscard]] TauComponents tau_components(const Graph& graph);
[[nodiscard]] TauComponents every_state_alone(const Graph& graph);
/// Returns a graph with one state for each component. A cyclic component gets a tau loop. The states have the numbers
/// of their components, so the initial state is component[0], which may differ from 0.
[[nodiscard]] Graph contract_components(const Graph& graph, const TauComponents& components);

}  // namespace robochart::lts
