// SPDX-License-Identifier: Apache-2.0
// Finds cycles in a graph whose edges are computed on demand. It takes linear time for graphs of all shapes.
#pragma once

#include <optional>
#include <vector>

#include "checker/lts/strong_components.hpp"

namespace robochart::refine {

using lts::GraphView;

/// Collects the targets of edges that do not lead forward, which means from a lower number to a higher one. Every cycle
/// contains such an edge.
class BackTargets {
public:
    void note_tau(lts::StateIndex from, lts::StateIndex to) {
        if (to <= from) add(to);
    }
    void add(lts::StateIndex vertex);
    /// Ascending.
    [[nodiscard]] std::vector<lts::StateIndex> list() const;

private:
    std::vector<bool> marked_;
};

/// Returns the least vertex on a cycle (including self-loops). `entrances`: all targets of edges that do not lead
/// forward, ascending. Vertices that cannot be reached from them are skipped.
[[nodiscard]] std::optional<lts::StateIndex> least_on_cycle(const GraphView& graph,
                                                            std::vector<lts::StateIndex> entrances);
/// Returns a shortest cycle through the vertex: the vertices after it, and finally the vertex itself. Empty if there is
/// none.
[[nodiscard]] std::vector<lts::StateIndex> shortest_cycle(const GraphView& graph, lts::StateIndex through);

}  // namespace robochart::refine
