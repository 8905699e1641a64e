// SPDX-License-Identifier: Apache-2.0
// Defines the input of a layout, which is one level of a diagram (boxes with sizes, edges with labels), and the
// resulting placement. Inner levels are laid out first, each separately. The size of a box includes its contents.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "frontend/diagrams/layout/geometry.hpp"

namespace robochart::diagrams::layout {

/// The direction of edges.
enum class Direction { down, right, best };

/// The end of the level to which a box is pinned: the first or the last layer.
enum class Pin { none, first, last };

/// The position of a box: its part of the level, the layer in that part, the index in the layer, and the row of the
/// part.
struct Rank {
    std::size_t part = 0, layer = 0, position = 0, row = 0;
    friend bool operator==(const Rank&, const Rank&) = default;
};

/// A square on the left or right border of a box. Edges may end at it. A level with ports is laid out to the right.
struct Port {
    double label_width = 0;  ///< the width of the text next to the square, inside the box
};

/// A node of the layout, joined by edges.
struct Box {
    Size size;           ///< minimum size; the box grows if edges, loops or ports need space
    bool round = false;  ///< true for a circle: it does not grow, and lines may meet in it
    bool entry = false;  ///< true for boxes at which the search for cycles starts
    Pin pin = Pin::none;
    bool on_border = false;  ///< true if the box is only a port on the border of the enclosing box
    std::vector<Port> ports;
    double port_start = 0;         ///< ports are below this distance from the top
    std::optional<Rank> previous;  ///< its position in the layout before an edit
};

/// An edge from a box to a box, which may be the same.
struct Edge {
    std::size_t from = 0, to = 0;
    std::optional<std::size_t> from_port, to_port;  ///< both or neither
    Size label;                                     ///< empty if it has none
    std::vector<std::size_t> previous;              ///< `PlacedEdge::ranks` in the layout before an edit
};

/// The input of a layout. Boxes and edges are in textual order, which breaks ties.
struct Level {
    std::vector<Box> boxes;
    std::vector<Edge> edges;
    Direction direction = Direction::best;
    std::optional<Direction> previous;  ///< the direction before an edit; used unless another direction is much better
};

/// The width of the square of a port.
inline constexpr double port_size = 18;

/// The placement of a port.
struct PlacedPort {
    bool left = false;  ///< true for a port on the left border; otherwise it is on the right border, unless it was
                        ///< drawn elsewhere
    Point centre;
    std::optional<Rectangle> label = {};  ///< the place of the label, if it is not next to the port
};

/// The placement of a box.
struct PlacedBox {
    Rectangle place;
    std::vector<PlacedPort> ports;
    Rank rank;
};

/// The route of an edge.
struct PlacedEdge {
    std::vector<Point> points;       ///< route from source to target; segments are horizontal and vertical in turn
    Rectangle label;                 ///< empty if it has none
    std::vector<std::size_t> ranks;  ///< its index in each layer that it passes, first layer first
};

/// The layout of a level. Everything is between (0, 0) and `size`.
struct Placement {
    Size size;
    std::vector<PlacedBox> boxes;
    std::vector<PlacedEdge> edges;
    Direction direction = Direction::down;
};

}  // namespace robochart::diagrams::layout
