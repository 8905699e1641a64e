// Strongly connected components of a graph's taus.
#pragma once

#include <vector>

#include "checker/lts/graph.hpp"

namespace robochart::lts {

struct TauComponents {
    std::vector<StateIndex> component;  ///< per state; a tau between components leads to a lower number
    std::vector<bool> cyclic;           ///< per component: its states can do taus for ever inside it
};

[[nodiscard]] TauComponents tau_components(const Graph& graph);
[[nodiscard]] TauComponents every_state_alone(const Graph& graph);
/// One state per component, with a tau to itself if it is cyclic. State numbers are component numbers: the initial
/// state is component[0], not 0.
[[nodiscard]] Graph contract(const Graph& graph, const TauComponents& components);

}  // namespace robochart::lts
