// The graph of layers that the steps of the layout work on. Its layers lie below each other; for edges that lead to the
// right, boxes and labels are turned before and turned back after.
//
// Even layers hold boxes, odd ones labels. An edge passes each layer between its ends in a node of its own, so that
// every link joins neighbouring layers, but for turns, where an edge leaves a port on the side away from its other end.
#pragma once

#include <cstddef>
#include <vector>

#include "diagnostics/budget.hpp"
#include "diagrams/layout/level.hpp"

namespace robochart::diagrams::layout {

/// No node, no port.
inline constexpr std::size_t nothing = static_cast<std::size_t>(-1);

/// A box, or the place where an edge passes a layer, with its label or without.
struct Node {
    enum class Kind { box, line, label };
    Kind kind = Kind::line;
    std::size_t box = nothing;  ///< of the level
    std::size_t edge = nothing;
    std::size_t layer = 0;
    std::size_t position = 0;                 ///< in its layer
    double before = 0, after = 0;             ///< how far it reaches to both sides of `x`
    double above = 0, below = 0;              ///< how far it reaches to both sides of the middle of its layer
    double loops = 0;                         ///< of `after`: what belongs to the loops beside the box
    double ports_above = 0, ports_below = 0;  ///< of `above` and `below`: what belongs to ports
    double x = 0;                             ///< of the line, or of the middle of the box
    std::vector<std::size_t> up, down;        ///< links

    [[nodiscard]] bool is_box() const { return kind == Kind::box; }
};

/// A piece of an edge between two layers, or a turn beside one.
struct Link {
    enum class Turn { none, under, over };
    std::size_t upper = nothing, lower = nothing;  ///< nodes; of one layer for a turn
    Turn turn = Turn::none;
    std::size_t edge = nothing;
    std::size_t upper_port = nothing, lower_port = nothing;  ///< of the box there
    double upper_x = 0, lower_x = 0;
    double upper_offset = 0, lower_offset = 0;  ///< of the ends from the middles of their boxes, as far as known
    /// The tracks that it runs on: y, and the x at which it goes on to the next one; the last goes on to `lower_x`.
    struct Track {
        double y = 0, x = 0;
    };
    std::vector<Track> tracks;
};

/// A port of a box: on which side it is, and where.
struct GraphPort {
    bool down = true;  ///< at the lower side
    double x = 0;
};

/// All nodes and links.
struct Graph {
    const Level* level = nullptr;
    bool turned = false;  ///< for edges that lead to the right
    bool has_ports = false;
    std::vector<Node> nodes;  ///< the boxes first, in their order
    std::vector<Link> links;
    std::vector<std::vector<std::size_t>> layers;  ///< nodes from left to right
    std::vector<std::size_t> layer_of_box;         ///< before layers are doubled
    std::vector<bool> reversed;                    ///< edges drawn against their direction
    std::vector<std::vector<std::size_t>> chains;  ///< links of each edge, from the upper end to the lower one
    std::vector<std::vector<GraphPort>> ports;     ///< of each box
    std::vector<double> layer_y;                   ///< the middle of each layer
    diagnostics::Budget* budget = nullptr;

    [[nodiscard]] double label_gap() const;
    void poll() const {
        if (budget != nullptr) budget->poll();
    }
};

/// How it is decided which edges of a cycle are drawn against their direction.
enum class Cycles {
    text,  ///< those that lead back in a search in depth, in the order of the text
    few,   ///< few, by the greedy heuristic of Eades, Lin and Smyth
    kept,  ///< as `text`, and those that join what an edit has added to what was there before
};
/// Decides which edges are drawn against their direction, so that none of the others are on a cycle.
void break_cycles(Graph& graph, Cycles cycles);
/// Gives each box its layer: each edge leads downwards.
void assign_layers(Graph& graph);
/// Makes the nodes and links of all edges, and decides on which side ports are. Throws TooLarge.
void make_nodes(Graph& graph);
/// How layers were ordered.
struct Ordered {
    std::size_t crossings = 0;
    bool as_before = true;  ///< what was there before an edit has kept its order
};
/// Orders the nodes of each layer so that few edges cross.
Ordered order_layers(Graph& graph);
/// Gives every node its x, and every link the x of its ends.
void place_nodes(Graph& graph);
/// Gives every layer its y, and every link its tracks.
void place_tracks(Graph& graph);

/// Sizes and distances in pixels.
namespace distance {
inline constexpr double boxes = 26;        ///< between two boxes
inline constexpr double box_line = 16;     ///< between a box and a line
inline constexpr double lines = 12;        ///< between two lines
inline constexpr double slots = 14;        ///< between two ends of edges on a side of a box
inline constexpr double slot_margin = 8;   ///< between such an end and the corner
inline constexpr double tracks = 10;       ///< between two parallel pieces of edges
inline constexpr double label = 5;         ///< between a line and its label
inline constexpr double label_below = 2;   ///< the same where the label is below the line
inline constexpr double ports = 28;        ///< between the middles of two ports
inline constexpr double port_margin = 15;  ///< between the middle of a port and the corner
inline constexpr double at_boxes = 14;     ///< between a layer of boxes and the tracks beside it
inline constexpr double at_labels = 7;     ///< the same for a layer of labels
inline constexpr double at_lines = 4;      ///< the same for a layer that only lines pass
inline constexpr double pieces = 6;        ///< between two pieces that are not to look like one
}  // namespace distance

inline double Graph::label_gap() const {
    return turned ? distance::label_below : distance::label;
}

/// Edges from a box to itself are stacked at its right side.
inline constexpr double loop_reach = 18;   ///< how far a loop goes out
inline constexpr double loop_margin = 10;  ///< above the first and below the last
inline constexpr double loop_gap = 6;      ///< between two
/// The height of a loop with its label.
[[nodiscard]] inline double loop_height(const Size& label) {
    constexpr double least = 14;
    return label.height > least ? label.height : least;
}

}  // namespace robochart::diagrams::layout
