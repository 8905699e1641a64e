// SPDX-License-Identifier: Apache-2.0
// Places the squares on the borders of boxes that a person has drawn, and the labels of the squares.
#pragma once

#include <vector>

#include "frontend/diagrams/layout/drawn_level.hpp"
#include "frontend/diagrams/layout/free_space.hpp"

namespace robochart::diagrams::layout {

/// Returns the square of a port as a rectangle.
[[nodiscard]] Rectangle square_at(const Point& centre);
/// Returns the squares of a box, without labels (see `ports_as_drawn`).
[[nodiscard]] std::vector<PlacedPort> squares_of(const Rectangle& box, double header, const DrawnPorts& drawn);
/// Places the labels of the squares in free space.
void label_ports(std::vector<PlacedPort>& ports, const DrawnPorts& drawn, FreeSpace& space);

/// Places squares on the border of a box, and their labels outside. Squares in the drawing keep their side. Others go
/// to free space on the right side. If a square would cover the title, it is moved outwards. `header` is the height of
/// the part of the box above its inside.
[[nodiscard]] std::vector<PlacedPort> ports_as_drawn(const Rectangle& box, double header, const DrawnPorts& drawn);

}  // namespace robochart::diagrams::layout
