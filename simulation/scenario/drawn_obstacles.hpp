// Obstacles that somebody drew: polygons of an SVG file (Scalable Vector Graphics 1.1, W3C 2011, chapters 8 and 9).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "simulation/world/geometry.hpp"

namespace robochart::simulation {

/// The polygons of `polygon`, `rect` without rounded corners, and `path` with straight lines that are closed, each by
/// its corners in the units of the drawing, with the y axis upwards and the middle of the drawing's `viewBox` at the
/// origin. What draws something else, transforms, style sheets and document types are refused, so that nothing that is
/// seen is passed over in silence. Empty on failure: `error` has the cause, with its line.
[[nodiscard]] std::vector<std::vector<Vector>> drawn_obstacles(std::string_view svg, std::string& error);

}  // namespace robochart::simulation
