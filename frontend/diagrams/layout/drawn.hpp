// SPDX-License-Identifier: Apache-2.0
// Lays out a level as a person drew it. Keeps the parts of the drawing that still fit, and lays out all others
// automatically.
#pragma once

#include "base/diagnostics/budget.hpp"
#include "frontend/diagrams/layout/drawn_level.hpp"

namespace robochart::diagrams::layout {

/// Returns the placement as drawn, with boxes enlarged if necessary. Boxes with `on_border` are on the border of the
/// enclosing box. Equal inputs give bitwise equal placements. Throws TooLarge.
[[nodiscard]] Placement arrange_as_drawn(const Level& level, const DrawnLevel& drawn,
                                         diagnostics::Budget* budget = nullptr);

}  // namespace robochart::diagrams::layout
