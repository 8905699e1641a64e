// Pictures for Mermaid, which many pages render from text.
#pragma once

#include <string>

#include "diagrams/notation/picture.hpp"

namespace robochart::diagrams {

/// Machines and operations as `stateDiagram-v2`, everything else as `flowchart`. What Mermaid has no notation for is
/// listed in comments at the head.
[[nodiscard]] std::string mermaid(const Picture& picture);

}  // namespace robochart::diagrams
