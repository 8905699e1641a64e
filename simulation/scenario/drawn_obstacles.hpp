// SPDX-License-Identifier: Apache-2.0
// Reads obstacles from a drawing: polygons of an SVG file (Scalable Vector Graphics 1.1, W3C 2011, chapters 8 and 9).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "simulation/world/geometry.hpp"

namespace robochart::simulation {

/// Returns the polygons of the elements `polygon`, `rect` (without rounded corners) and `path` (closed, with straight
/// lines). The corners of a polygon are in the units of the drawing, with the y axis upwards and the centre of the
/// drawing's `viewBox` at the origin. Other drawing elements, transforms, style sheets and document types are rejected,
/// so that no visible element is silently ignored. If the drawing is rejected, the result is empty, and `error`
/// contains the reason and its line.
[[nodiscard]] std::vector<std::vector<Vector>> drawn_obstacles(std::string_view svg, std::string& error);

}  // namespace robochart::simulation
