// What can be said of the geometry of a diagram whatever it shows: the criteria that every layout has to meet.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "diagrams/layout/level.hpp"
#include "diagrams/notation/picture.hpp"

namespace robochart::diagrams {

/// No box.
inline constexpr std::size_t no_box = static_cast<std::size_t>(-1);

/// A box, a circle, or the square of a port.
struct SceneBox {
    std::string name;
    layout::Rectangle place;
    std::size_t parent = no_box;   ///< of boxes, the one that it is in
    std::size_t port_of = no_box;  ///< of a square, the box on whose border it is
    bool round = false;
    bool frame = false;  ///< everything is in it, also lines from the squares on its border
};

/// An edge between two boxes of one level.
struct SceneLine {
    std::string name;
    std::size_t from = 0, to = 0;
    std::vector<layout::Point> points;
    layout::Rectangle label;
};

/// A diagram.
struct Scene {
    std::vector<SceneBox> boxes;
    std::vector<SceneLine> lines;
};

/// A picture.
[[nodiscard]] Scene scene_of(const Picture&);

/// A level and where it was put.
[[nodiscard]] Scene scene_of(const layout::Level&, const layout::Placement&);

/// What is wrong with it, a sentence each; empty for a good one: boxes of a level, labels and squares do not overlap;
/// no label is on a line; no two lines run on each other (but into a circle or a square that they share); no line leads
/// through a box; every end is on the border of its box; lines are horizontal and vertical; what is in a box is within
/// it.
[[nodiscard]] std::vector<std::string> faults_of(const Scene&);

/// How often lines cross.
[[nodiscard]] std::size_t crossings_of(const Scene&);

/// Of all pairs of boxes of one level that both scenes have (by name), the share whose order from left to right or from
/// top to bottom is another one.
struct Flips {
    std::size_t pairs = 0, flipped = 0;
};
[[nodiscard]] Flips flips_between(const Scene& before, const Scene& after);

}  // namespace robochart::diagrams
