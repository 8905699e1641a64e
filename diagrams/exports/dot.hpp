// Pictures for Graphviz, whose programs lay them out anew.
#pragma once

#include <string>

#include "diagrams/notation/picture.hpp"

namespace robochart::diagrams {

/// A directed graph; what has boxes in it or events on its border is a cluster.
[[nodiscard]] std::string dot(const Picture& picture);

}  // namespace robochart::diagrams
