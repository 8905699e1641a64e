// SPDX-License-Identifier: Apache-2.0
// Computes the routes of edges between boxes that a person has drawn.
#pragma once

#include <vector>

#include "frontend/diagrams/layout/drawn_level.hpp"
#include "frontend/diagrams/layout/free_space.hpp"

namespace robochart::diagrams::layout {

/// An end of an edge: a box, a circle, or the square of a port.
struct RouteEnd {
    enum class Shape { box, circle, square };
    Rectangle place;
    Shape shape = Shape::box;
};

/// Returns the drawn route from border to border. Returns an empty list if the drawing has no route, if the route no
/// longer fits the boxes, or if it is a single diagonal line although routes must be orthogonal.
[[nodiscard]] std::vector<Point> route_as_drawn(const DrawnEdge& edge, const RouteEnd& from, const RouteEnd& to);

/// Returns an orthogonal route that avoids existing elements.
[[nodiscard]] std::vector<Point> new_route(const RouteEnd& from, const RouteEnd& to, const FreeSpace& space);

}  // namespace robochart::diagrams::layout
