// Cycles in a graph given by its adjacency: linear, whatever the graph's shape.
#pragma once

#include <functional>
#include <optional>

#include "checker/lts/state_store.hpp"

namespace robochart::refine {

/// Vertices 0 .. size-1; edge(v, i) is the i-th successor of v, or no_state beyond its last.
struct GraphView {
    std::size_t size;
    std::function<lts::StateIndex(lts::StateIndex, std::size_t)> edge;
};

/// The least vertex that lies on a cycle (a self-loop is one).
[[nodiscard]] std::optional<lts::StateIndex> least_on_cycle(const GraphView& graph);
/// A shortest cycle through the vertex: the vertices after it, ending with itself. Empty if there is none.
[[nodiscard]] std::vector<lts::StateIndex> shortest_cycle(const GraphView& graph, lts::StateIndex through);

}  // namespace robochart::refine
