// Routes of edges between boxes that stand where a person put them.
#pragma once

#include <vector>

#include "diagrams/layout/drawn_level.hpp"
#include "diagrams/layout/free_space.hpp"

namespace robochart::diagrams::layout {

/// Where an edge ends: a box, a circle, or the square of a port.
struct RouteEnd {
    enum class Shape { box, circle, square };
    Rectangle place;
    Shape shape = Shape::box;
};

/// From border to border as drawn; empty where the drawing has no route, only a line askew that is to have right
/// angles, or one that fits the boxes no more.
[[nodiscard]] std::vector<Point> route_as_drawn(const DrawnEdge& edge, const RouteEnd& from, const RouteEnd& to);

/// A route with right angles that avoids what is there.
[[nodiscard]] std::vector<Point> new_route(const RouteEnd& from, const RouteEnd& to, const FreeSpace& space);

}  // namespace robochart::diagrams::layout
