// SPDX-License-Identifier: Apache-2.0
// The layout of a level as a person drew it. Parts of the drawing that still fit are used; missing parts are laid out
// automatically.
#pragma once

#include "base/diagnostics/budget.hpp"
#include "frontend/diagrams/layout/drawn_level.hpp"

namespace robochart::diagrams::layout {

/// The placement as drawn; boxes are enlarged if necessary. Boxes with `on_border` are on the border of the enclosing
/// box. Deterministic: equal input gives bitwise equal placements. Throws TooLarge.
[[nodiscard]] Placement arrange_as_drawn(const Level& level, const DrawnLevel& drawn,
                                         diagnostics::Budget* budget = nullptr);

}  // namespace robochart::diagrams::layout
