// SPDX-License-Identifier: Apache-2.0
// Converts the layered graph back to boxes and edges.
#pragma once

#include "frontend/diagrams/layout/graph.hpp"
#include "frontend/diagrams/layout/level.hpp"

namespace robochart::diagrams::layout {

/// Returns the placement of a graph whose nodes have positions and whose links have tracks.
[[nodiscard]] Placement placement_of(const Graph& graph);

}  // namespace robochart::diagrams::layout
