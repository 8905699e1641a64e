// SPDX-License-Identifier: Apache-2.0
// Defines the layered graph on which the steps of the layout work. Layers are stacked from top to bottom. For a layout
// to the right, boxes and labels are transposed first, and the result is transposed back.
//
// Even layers contain boxes, and odd layers contain labels. An edge has a node in each layer between its ends, so that
// every link joins adjacent layers. The only exceptions are turns. A turn is a link of an edge that leaves a port on
// the side away from the edge's other end.
#pragma once

#include <cstddef>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "frontend/diagrams/layout/level.hpp"

namespace robochart::diagrams::layout {

/// The index that means no node or no port.
inline constexpr std::size_t nothing = static_cast<std::size_t>(-1);

/// A box, or the place where an edge passes a layer, with or without its label.
struct Node {
    enum class Kind { box, line, label };
    Kind kind = Kind::line;
    std::size_t box = nothing;  ///< index of the box in the level
    std::size_t edge = nothing;
    std::size_t layer = 0;
    std::size_t position = 0;                 ///< index of the node in its layer
    double before = 0, after = 0;             ///< extent on both sides of `x`
    double above = 0, below = 0;              ///< extent on both sides of the middle of the node's layer
    double loops = 0;                         ///< the part of `after` needed by the loops at the box
    double ports_above = 0, ports_below = 0;  ///< the parts of `above` and `below` needed by ports
    double x = 0;                             ///< x of the line, or of the middle of the box
    std::vector<std::size_t> up, down;        ///< links

    [[nodiscard]] bool is_box() const { return kind == Kind::box; }
};

/// A part of an edge between two layers, or a turn next to one layer.
struct Link {
    enum class Turn { none, under, over };
    std::size_t upper = nothing, lower = nothing;  ///< nodes; in the same layer for a turn
    Turn turn = Turn::none;
    std::size_t edge = nothing;
    std::size_t upper_port = nothing, lower_port = nothing;  ///< index in the box of that node
    double upper_x = 0, lower_x = 0;
    double upper_offset = 0, lower_offset = 0;  ///< distances of the ends from the middles of their boxes, if known
    /// A track of the link: its y, and the x at which the link continues to the next track. The last track continues to
    /// `lower_x`.
    struct Track {
        double y = 0, x = 0;
    };
    std::vector<Track> tracks;
};

/// A port of a box: its side and position.
struct GraphPort {
    bool down = true;  ///< the port is on the lower side
    double x = 0;
};

/// The graph of one level.
struct Graph {
    const Level* level = nullptr;
    bool turned = false;  ///< transposed, for a layout to the right
    bool has_ports = false;
    std::vector<Node> nodes;  ///< the boxes first, in their order
    std::vector<Link> links;
    std::vector<std::vector<std::size_t>> layers;  ///< nodes from left to right
    std::vector<std::size_t> layer_of_box;         ///< the layer of each box, before label layers are inserted
    std::vector<bool> reversed;                    ///< edges drawn against their direction
    std::vector<std::vector<std::size_t>> chains;  ///< the links of each edge, from the upper end to the lower one
    std::vector<std::vector<GraphPort>> ports;     ///< the ports of each box
    std::vector<double> layer_y;                   ///< the middle of each layer
    diagnostics::Budget* budget = nullptr;

    [[nodiscard]] double label_gap() const;
    void poll() const {
        if (budget != nullptr) budget->poll();
    }
};

/// The method that selects the edges to be drawn against their direction, so that no cycle remains.
enum class Cycles {
    text,  ///< back edges of a depth-first search in textual order
    few,   ///< few edges, by the greedy heuristic of Eades, Lin and Smyth
    kept,  ///< as `text`, but also edges between added boxes and boxes that existed before
};
/// Selects the edges that are drawn against their direction, so that the remaining edges have no cycle.
void break_cycles(Graph& graph, Cycles cycles);
/// Assigns a layer to each box, so that all edges lead downwards.
void assign_layers(Graph& graph);
/// Makes the nodes and links of all edges, and chooses the sides of ports. Throws TooLarge.
void make_nodes(Graph& graph);
/// The result of ordering the layers.
struct Ordered {
    std::size_t crossings = 0;
    bool as_before = true;  ///< boxes that existed before an edit have kept their order
};
/// Orders the nodes of each layer so that few edges cross.
Ordered order_layers(Graph& graph);
/// Computes the x of every node and of the ends of every link.
void place_nodes(Graph& graph);
/// Computes the y of every layer and the tracks of every link.
void place_tracks(Graph& graph);

/// Sizes and distances in pixels.
namespace distance {
inline constexpr double boxes = 26;        ///< between two boxes
inline constexpr double box_line = 16;     ///< between a box and a line
inline constexpr double lines = 12;        ///< between two lines
inline constexpr double slots = 14;        ///< between two edge ends on a side of a box
inline constexpr double slot_margin = 8;   ///< between an edge end and the corner
inline constexpr double tracks = 10;       ///< between two parallel edge segments
inline constexpr double label = 5;         ///< between a line and its label
inline constexpr double label_below = 2;   ///< between a line and a label below it
inline constexpr double ports = 28;        ///< between the centres of two ports
inline constexpr double port_margin = 15;  ///< between the centre of a port and the corner
inline constexpr double at_boxes = 14;     ///< between a layer of boxes and the adjacent tracks
inline constexpr double at_labels = 7;     ///< between a layer of labels and the adjacent tracks
inline constexpr double at_lines = 4;      ///< between a layer with only lines and the adjacent tracks
inline constexpr double pieces = 6;        ///< between two segments that must remain distinguishable
}  // namespace distance

inline double Graph::label_gap() const {
    return turned ? distance::label_below : distance::label;
}

/// Edges from a box to itself are stacked at its right side.
inline constexpr double loop_reach = 18;   ///< horizontal extent of a loop
inline constexpr double loop_margin = 10;  ///< above the first and below the last
inline constexpr double loop_gap = 6;      ///< between two loops
/// Returns the height of a loop with its label.
[[nodiscard]] inline double loop_height(const Size& label) {
    constexpr double least = 14;
    return label.height > least ? label.height : least;
}

}  // namespace robochart::diagrams::layout
