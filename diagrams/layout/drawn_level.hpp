// A level as a person drew it, as data: places of boxes and squares, ends and bends of edges. Nothing stands for what
// the drawing does not have.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "diagrams/layout/level.hpp"

namespace robochart::diagrams::layout {

/// A box within its level.
struct DrawnBox {
    Point corner;
    std::optional<double> width, height;  ///< none: as large as it has to be
};

/// A square on the border of a box or of what the level is in.
struct DrawnPort {
    Point centre;              ///< from the corner of the box
    Side label = Side::right;  ///< where its label was
};

/// How an edge was drawn. A bend, or an end, is given from an anchor in each of the two boxes; where the boxes have
/// other sizes than in the drawing, it lies between both.
struct DrawnEdge {
    struct Bend {
        Point from_source, from_target;
    };
    Point source_anchor{0.5, 0.5}, target_anchor{0.5, 0.5};  ///< as shares of width and height
    std::vector<Bend> bends;                                 ///< from end to end; fewer than two: no route is known
    bool right_angled = true;
    std::optional<Point> label;  ///< the middle of the label, from the middle of the route
};

/// The squares of a box, in the order of the box's ports.
struct DrawnPorts {
    std::vector<std::optional<DrawnPort>> ports;
    std::vector<Size> labels;  ///< of what is written beside each
    Size owner;                ///< size of the box in the drawing, as far as it is known
    double header = 0;         ///< what was above its inside in the drawing: squares below move with that
    bool full = false;         ///< there is no space for labels in the box
};

/// All of it, in the order of the level's boxes and edges; nothing stands for what the drawing does not have.
struct DrawnLevel {
    std::vector<std::optional<DrawnBox>> boxes;
    std::vector<DrawnPorts> ports;  ///< of boxes on the border, those of what the level is in
    std::vector<std::optional<DrawnEdge>> edges;
    Size size;          ///< of the level, at least
    double header = 0;  ///< height of what is above the level in what it is in
};

}  // namespace robochart::diagrams::layout
