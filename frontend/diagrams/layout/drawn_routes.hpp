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

/// Returns the drawn route from border to border. It is empty if the drawing has no route or the route no longer fits
/// the boxes. It is also empty if the drawing has only a diagonal line but the route must be orthogonal.
[[nodiscard]] std::vector<Point> route_as_drawn(const DrawnEdge& edge, const RouteEnd& from, const RouteEnd& to);

/// Returns an orthogonal route that avoids existing elements.
[[nodiscard]] std::vector<Point> new_route(const RouteEnd& from, const RouteEnd& to, const FreeSpace& space);

}  // namespace robochart::diagrams::layout
