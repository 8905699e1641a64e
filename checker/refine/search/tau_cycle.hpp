// SPDX-License-Identifier: Apache-2.0
// Finds cycles in a graph whose edges are computed on demand. The algorithms take linear time for every graph.
#pragma once

#include <optional>
#include <vector>

#include "checker/lts/strong_components.hpp"

namespace robochart::refine {

using lts::GraphView;

/// Collects the targets of edges that do not lead forward. An edge leads forward if its target has a higher number than
/// its source. Every cycle contains an edge that does not lead forward.
class BackTargets {
public:
    void note_tau(lts::StateIndex from, lts::StateIndex to) {
        if (to <= from) add(to);
    }
    void add(lts::StateIndex vertex);
    /// Returns the targets, ascending.
    [[nodiscard]] std::vector<lts::StateIndex> list() const;

private:
    std::vector<bool> marked_;
};

/// Returns the least vertex on a cycle (including self-loops). `entrances` must contain all targets of edges that do
/// not lead forward, ascending. Vertices that cannot be reached from these entrances are skipped.
[[nodiscard]] std::optional<lts::StateIndex> least_on_cycle(const GraphView& graph,
                                                            std::vector<lts::StateIndex> entrances);
/// Returns a shortest cycle through the vertex: the vertices after it, and finally the vertex itself. Returns an empty
/// list if there is no cycle.
[[nodiscard]] std::vector<lts::StateIndex> shortest_cycle(const GraphView& graph, lts::StateIndex through);

}  // namespace robochart::refine
