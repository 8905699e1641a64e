// SPDX-License-Identifier: Apache-2.0
// Computes the strongly connected components of a graph whose edges are computed on demand.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "checker/lts/index_table.hpp"

namespace robochart::lts {

/// A graph with the vertices 0 .. size-1. `successors` appends the successors of a vertex to a list. It must give the
/// same successors in each call.
struct GraphView {
    std::size_t size;
    std::function<void(StateIndex vertex, std::vector<StateIndex>& targets)> successors;
};

/// Receives the vertices of a component. `cyclic` is true if the component contains an edge. The vertices are valid
/// only during the call.
using OnComponent = std::function<void(std::span<const StateIndex> members, bool cyclic)>;

/// Reports the components that are reachable from the roots. A component is reported after all components to which its
/// edges lead. The order depends only on the roots and edges. The function uses Tarjan's algorithm (Depth-first search
/// and linear graph algorithms, 1972). It takes linear time, without recursion, and calls `successors` once for each
/// vertex. It stores eight bytes for each vertex, and the targets of the vertices on the current path.
void strong_components(const GraphView& graph, std::span<const StateIndex> roots, const OnComponent& report);

}  // namespace robochart::lts
