// The layout of a level, in layers (Sugiyama, Tagawa, Toda: Methods for visual understanding of hierarchical system
// structures, 1981). docs/diagrams.md describes its steps.
#pragma once

#include <stdexcept>

#include "diagnostics/budget.hpp"
#include "diagrams/layout/level.hpp"

namespace robochart::diagrams::layout {

/// A level is too large to be laid out in reasonable time and space.
class TooLarge : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The same level gives the same placement, bit by bit. Throws TooLarge.
[[nodiscard]] Placement arrange(const Level& level, diagnostics::Budget* budget = nullptr);

}  // namespace robochart::diagrams::layout
