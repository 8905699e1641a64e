// SPDX-License-Identifier: Apache-2.0
// Computes the layered layout of a level (Sugiyama, Tagawa, Toda: Methods for visual understanding of hierarchical
// system structures, 1981). docs/diagrams.md describes the steps.
#pragma once

#include <stdexcept>

#include "base/diagnostics/budget.hpp"
#include "frontend/diagrams/layout/level.hpp"

namespace robochart::diagrams::layout {

/// Thrown if a level is too large to be laid out with reasonable time and memory.
class TooLarge : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Computes the layout. Equal levels get bitwise equal placements. Throws TooLarge.
[[nodiscard]] Placement arrange_level(const Level& level, diagnostics::Budget* budget = nullptr);

}  // namespace robochart::diagrams::layout
