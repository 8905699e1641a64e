// SPDX-License-Identifier: Apache-2.0
// Strongly connected components of the taus of a graph.
#pragma once

#include <vector>

#include "checker/lts/graph.hpp"

namespace robochart::lts {

struct TauComponents {
    std::vector<StateIndex> component;  ///< by state; a tau between components leads to a lower number
    std::vector<bool> cyclic;           ///< by component: its states can perform taus forever inside it
};

[[nodiscard]] TauComponents tau_components(const Graph& graph);
[[nodiscard]] TauComponents every_state_alone(const Graph& graph);
/// One state for each component, with a tau loop if it is cyclic. State numbers are component numbers, so the initial
/// state is component[0], not 0.
[[nodiscard]] Graph contract(const Graph& graph, const TauComponents& components);

}  // namespace robochart::lts
