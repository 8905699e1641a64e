// SPDX-License-Identifier: Apache-2.0
// Computes the strongly connected components of the taus of a graph, and contracts them.
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
/// Returns a graph with one state for each component, and a tau loop if the component is cyclic. The state for a
/// component has the number of the component. So the initial state is component[0], and this number may differ from 0.
[[nodiscard]] Graph contract_components(const Graph& graph, const TauComponents& components);

}  // namespace robochart::lts
