// Strongly connected components of a graph whose edges are made as they are asked for.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "checker/lts/index_table.hpp"

namespace robochart::lts {

/// Vertices 0 .. size-1; `successors` adds those of a vertex to a list, the same every time.
struct GraphView {
    std::size_t size;
    std::function<void(StateIndex vertex, std::vector<StateIndex>& targets)> successors;
};

/// Receives the vertices of a component; `cyclic`: an edge of theirs stays inside it. Valid during the call only.
using OnComponent = std::function<void(std::span<const StateIndex> members, bool cyclic)>;

/// Reports the components of what the roots lead to, each after those that its edges lead to; the order depends on
/// roots and edges alone. Linear in time, without recursion; asks for the successors of each vertex once, and keeps
/// eight bytes for each vertex and the targets of those on the path (Tarjan, Depth-first search and linear graph
/// algorithms, 1972).
void strong_components(const GraphView& graph, std::span<const StateIndex> roots, const OnComponent& report);

}  // namespace robochart::lts
