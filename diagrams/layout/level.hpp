// One level of a diagram, as a layout sees it: boxes with sizes, edges with labels; and where they go. Levels inside of
// boxes are laid out before, each alone: a box is as large as what is in it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "diagrams/layout/geometry.hpp"

namespace robochart::diagrams::layout {

/// In which direction edges lead.
enum class Direction { down, right, best };

/// Boxes that are to stand at an end of the level: in the first layer or in the last.
enum class Pin { none, first, last };

/// Where a box stood: the part of the level that edges join, the layer in it, and the place in that; and in which row
/// of parts.
struct Rank {
    std::size_t part = 0, layer = 0, position = 0, row = 0;
    friend bool operator==(const Rank&, const Rank&) = default;
};

/// A square on the left or right border of a box, at which edges end. A level with ports leads to the right.
struct Port {
    double label_width = 0;  ///< of the text inside of the box beside it
};

/// What edges join.
struct Box {
    Size size;           ///< at least; it grows where edges, loops or ports need space
    bool round = false;  ///< a circle: it does not grow, and lines may meet in it
    bool entry = false;  ///< the search for cycles begins here
    Pin pin = Pin::none;
    bool on_border = false;  ///< nothing but its one port, which is on the border of what the level is in
    std::vector<Port> ports;
    double port_start = 0;         ///< ports are below this distance from the top
    std::optional<Rank> previous;  ///< in the layout before an edit
};

/// From a box to a box, perhaps the same.
struct Edge {
    std::size_t from = 0, to = 0;
    std::optional<std::size_t> from_port, to_port;  ///< both or none
    Size label;                                     ///< empty: it has none
    std::vector<std::size_t> previous;              ///< `PlacedEdge::ranks` in the layout before an edit
};

/// In the order of the text: where everything else is equal, what is first stands first.
struct Level {
    std::vector<Box> boxes;
    std::vector<Edge> edges;
    Direction direction = Direction::best;
    std::optional<Direction> previous;  ///< in the layout before an edit; kept unless another is much better
};

/// Width of the square of a port.
inline constexpr double port_size = 18;

/// Where a port is.
struct PlacedPort {
    bool left = false;  ///< on the left border; else on the right one, where no drawing says otherwise
    Point centre;
    std::optional<Rectangle> label = {};  ///< where it is not in the box beside the port
};

/// Where a box is.
struct PlacedBox {
    Rectangle place;
    std::vector<PlacedPort> ports;
    Rank rank;
};

/// How an edge is drawn.
struct PlacedEdge {
    std::vector<Point> points;       ///< from its source to its target, horizontal and vertical in turn
    Rectangle label;                 ///< empty where it has none
    std::vector<std::size_t> ranks;  ///< its places in the layers that it passes, from the first on
};

/// A level laid out; everything lies between (0, 0) and `size`.
struct Placement {
    Size size;
    std::vector<PlacedBox> boxes;
    std::vector<PlacedEdge> edges;
    Direction direction = Direction::down;
};

}  // namespace robochart::diagrams::layout
