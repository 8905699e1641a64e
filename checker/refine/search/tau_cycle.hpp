// Cycles in a graph whose edges are made as they are asked for: linear, whatever the graph's shape.
#pragma once

#include <optional>
#include <vector>

#include "checker/lts/strong_components.hpp"

namespace robochart::refine {

using lts::GraphView;

/// The vertices to which an edge leads that does not lead forward, from a lower number to a higher: every cycle has
/// one.
class BackTargets {
public:
    void note(lts::StateIndex from, lts::StateIndex to) {
        if (to <= from) add(to);
    }
    void add(lts::StateIndex vertex);
    /// Ascending.
    [[nodiscard]] std::vector<lts::StateIndex> list() const;

private:
    std::vector<bool> marked_;
};

/// The least vertex that lies on a cycle (a self-loop is one). `entrances`: the targets of edges that do not lead
/// forward, all of them, ascending; pairs that no such edge leads to, directly or indirectly, are skipped.
[[nodiscard]] std::optional<lts::StateIndex> least_on_cycle(const GraphView& graph,
                                                            std::vector<lts::StateIndex> entrances);
/// A shortest cycle through the vertex: the vertices after it, ending with itself. Empty if there is none.
[[nodiscard]] std::vector<lts::StateIndex> shortest_cycle(const GraphView& graph, lts::StateIndex through);

}  // namespace robochart::refine
