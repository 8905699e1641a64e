// SPDX-License-Identifier: Apache-2.0
// Exports pictures to Mermaid, which many websites render from text.
#pragma once

#include <string>

#include "frontend/diagrams/notation/picture.hpp"

namespace robochart::diagrams {

/// Machines and operations become a `stateDiagram-v2`; other diagrams become a `flowchart`. Comments at the top list
/// the elements for which Mermaid has no notation.
[[nodiscard]] std::string render_mermaid(const Picture& picture);

}  // namespace robochart::diagrams
