// SPDX-License-Identifier: Apache-2.0
// Computes the strongly connected components of a graph. The graph is a function that computes edges on demand.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "checker/lts/index_table.hpp"

namespace robochart::lts {

/// A graph with the vertices 0 .. size-1. `successors` appends the successors of a vertex to a list. For one vertex,
/// every call must append the same list.
struct GraphView {
    std::size_t size;
    std::function<void(StateIndex vertex, std::vector<StateIndex>& targets)> successors;
};

/// Receives the vertices of a component. `cyclic`: the component contains an edge. The vertices are only valid until
/// the call returns.
using OnComponent = std::function<void(std::span<const StateIndex> members, bool cyclic)>;

/// Reports the components that the roots can reach. A component comes after all components to which its edges lead. The
/// order of the components depends only on the roots and the edges. Uses Tarjan's algorithm (Depth-first search and
/// linear graph algorithms, 1972) without recursion, so it takes linear time and calls `successors` once for each
/// vertex. Stores eight bytes for each vertex, and the targets of the vertices on the current path.
void strong_components(const GraphView& graph, std::span<const StateIndex> roots, const OnComponent& report);

}  // namespace robochart::lts
