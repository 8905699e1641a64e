// SPDX-License-Identifier: Apache-2.0
// Generates random levels of every shape from a seed.
#pragma once

#include <cstdint>

#include "frontend/diagrams/layout/level.hpp"

namespace robochart::diagrams {

/// Returns states, junctions, transitions with and without labels, and loops, in one or more connected parts.
[[nodiscard]] layout::Level random_machine(std::uint64_t seed, std::size_t most_boxes);
/// Returns components with events on their borders, and connections between them and to the border of the enclosing
/// component.
[[nodiscard]] layout::Level random_components(std::uint64_t seed, std::size_t most_boxes);

}  // namespace robochart::diagrams
