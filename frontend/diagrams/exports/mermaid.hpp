// SPDX-License-Identifier: Apache-2.0
// Exports pictures as text for Mermaid, which many websites render.
#pragma once

#include <string>

#include "frontend/diagrams/notation/picture.hpp"

namespace robochart::diagrams {

/// Returns the picture as a `stateDiagram-v2` if it shows a machine or an operation, and as a `flowchart` otherwise.
/// Comments at the top of the text list the elements for which Mermaid has no notation.
[[nodiscard]] std::string render_mermaid(const Picture& picture);

}  // namespace robochart::diagrams
