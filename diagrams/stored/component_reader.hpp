// From the shapes and lines of a file to the layouts of the components in it.
#pragma once

#include <utility>
#include <vector>

#include "diagrams/stored/fragments.hpp"
#include "diagrams/stored/stored_diagrams.hpp"

namespace robochart::diagrams {

/// The components that a diagram shows, in the order of the file; also those inside of others.
[[nodiscard]] std::vector<std::pair<const frontend::Declaration*, StoredDiagram>> read_components(
    const AirdDiagram& diagram, const Fragments& fragments, diagnostics::Budget* budget);

}  // namespace robochart::diagrams
