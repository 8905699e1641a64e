// SPDX-License-Identifier: Apache-2.0
// Exports pictures as text for Graphviz, which computes its own layout.
#pragma once

#include <string>

#include "frontend/diagrams/notation/picture.hpp"

namespace robochart::diagrams {

/// Returns the picture as a directed graph. A box that contains boxes, or has events on its border, becomes a cluster.
[[nodiscard]] std::string render_dot(const Picture& picture);

}  // namespace robochart::diagrams
