// SPDX-License-Identifier: Apache-2.0
// Obstacles from a drawing: polygons of an SVG file (Scalable Vector Graphics 1.1, W3C 2011, chapters 8 and 9).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "simulation/world/geometry.hpp"

namespace robochart::simulation {

/// The polygons of `polygon`, `rect` without rounded corners, and `path` with straight lines that are closed. Each is
/// given by its corners in the units of the drawing, with the y axis upwards and the centre of the drawing's `viewBox`
/// at the origin. Other drawing elements, transforms, style sheets and document types are rejected, so that no visible
/// element is ignored silently. Empty on failure: `error` contains the cause and its line.
[[nodiscard]] std::vector<std::vector<Vector>> drawn_obstacles(std::string_view svg, std::string& error);

}  // namespace robochart::simulation
