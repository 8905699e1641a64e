// SPDX-License-Identifier: Apache-2.0
// Computes the strongly connected components of a graph's taus, and contracts each component to one state.
#pragma once

#include <vector>

#include "checker/lts/graph.hpp"

namespace robochart::lts {

struct TauComponents {
    std::vector<StateIndex> component;  ///< by state; a tau between components leads to a lower number
    std::vector<bool> cyclic;           ///< by component: true if it contains a cycle of taus
};

[[nodiscard]] TauComponents tau_components(const Graph& graph);
[[nodiscard]] TauComponents every_state_alone(const Graph& graph);
/// Returns a graph with one state for each component. A cyclic component becomes a state with a tau to itself. The
/// number of a state is the number of its component, so the initial state is component[0], which may differ from 0.
[[nodiscard]] Graph contract_components(const Graph& graph, const TauComponents& components);

}  // namespace robochart::lts
