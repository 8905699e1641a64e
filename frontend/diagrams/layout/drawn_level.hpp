// SPDX-License-Identifier: Apache-2.0
// Represents a level as a person drew it: positions of boxes and squares, ends and bends of edges. Elements that are
// not in the drawing have no value.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "frontend/diagrams/layout/level.hpp"

namespace robochart::diagrams::layout {

/// A box within its level.
struct DrawnBox {
    Point corner;
    std::optional<double> width, height;  ///< no value: as large as necessary
};

/// A square on the border of a box or of the enclosing box.
struct DrawnPort {
    Point centre;              ///< relative to the corner of the box
    Side label = Side::right;  ///< side of the label in the drawing
};

/// The route and the label of an edge as a person drew them. A bend or an end is stored relative to an anchor in each
/// of the two boxes. If a box has changed its size, these two positions differ; the bend is then placed between them.
struct DrawnEdge {
    struct Bend {
        Point from_source, from_target;
    };
    Point source_anchor{0.5, 0.5}, target_anchor{0.5, 0.5};  ///< anchors as fractions of width and height
    std::vector<Bend> bends;  ///< in order from end to end; if there are fewer than two, the route is unknown
    bool right_angled = true;
    std::optional<Point> label;  ///< the middle of the label, relative to the middle of the route
};

/// The squares of a box, in the order of the box's ports.
struct DrawnPorts {
    std::vector<std::optional<DrawnPort>> ports;
    std::vector<Size> labels;  ///< sizes of the labels of the squares
    Rectangle title;           ///< the text of the title, relative to the middle of the upper side; empty if none
    Size owner;                ///< size of the box in the drawing, if known
    double header = 0;         ///< height above the inside in the drawing; squares below move with it
    bool full = false;         ///< the box has no space for labels
};

/// The whole drawing, in the order of the level's boxes and edges. Elements that are not in the drawing have no value.
struct DrawnLevel {
    std::vector<std::optional<DrawnBox>> boxes;
    std::vector<DrawnPorts> ports;  ///< squares of the boxes; for a box on the border, the squares of the enclosing box
    std::vector<std::optional<DrawnEdge>> edges;
    Size size;          ///< the minimum size of the level
    double header = 0;  ///< height of the part of the enclosing box above the level
};

}  // namespace robochart::diagrams::layout
