// Squares on the borders of boxes that stand where a person put them, and their labels.
#pragma once

#include <vector>

#include "diagrams/layout/drawn_level.hpp"
#include "diagrams/layout/free_space.hpp"

namespace robochart::diagrams::layout {

/// The square of a port.
[[nodiscard]] Rectangle square_at(const Point& centre);
/// The squares of a box, without labels (`ports_as_drawn`).
[[nodiscard]] std::vector<PlacedPort> squares_of(const Rectangle& box, double header, const DrawnPorts& drawn);
/// Gives them labels where nothing else is.
void label_ports(std::vector<PlacedPort>& ports, const DrawnPorts& drawn, FreeSpace& space);

/// Squares on the border of a box, with their labels outside of it: those of the drawing on the side where they were,
/// others where there is space on the right side. `header`: height of what is above the inside of the box now.
[[nodiscard]] std::vector<PlacedPort> ports_as_drawn(const Rectangle& box, double header, const DrawnPorts& drawn);

}  // namespace robochart::diagrams::layout
