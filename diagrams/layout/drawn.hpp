// The layout of a level as a person drew it: what fits is kept, and what the drawing does not have is laid out anew.
#pragma once

#include "diagnostics/budget.hpp"
#include "diagrams/layout/drawn_level.hpp"

namespace robochart::diagrams::layout {

/// The placement as drawn; boxes are larger than drawn where they have to be. Boxes on the border are on that of what
/// the level is in. The same drawing and level give the same placement, bit by bit. Throws TooLarge.
[[nodiscard]] Placement arrange_as_drawn(const Level& level, const DrawnLevel& drawn,
                                         diagnostics::Budget* budget = nullptr);

}  // namespace robochart::diagrams::layout
