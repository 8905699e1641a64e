// SPDX-License-Identifier: Apache-2.0
// Converts the shapes and lines of a file to the layouts of its components.
#pragma once

#include <utility>
#include <vector>

#include "frontend/diagrams/stored/fragments.hpp"
#include "frontend/diagrams/stored/stored_diagrams.hpp"

namespace robochart::diagrams {

/// Returns the layouts of the components that a diagram shows, including inner ones, in the order of the file.
[[nodiscard]] std::vector<std::pair<const frontend::Declaration*, StoredDiagram>> read_components(
    const AirdDiagram& diagram, const Fragments& fragments, diagnostics::Budget* budget);

}  // namespace robochart::diagrams
