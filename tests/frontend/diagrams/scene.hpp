// SPDX-License-Identifier: Apache-2.0
// Describes the geometry of any diagram, and checks the criteria that every layout must satisfy.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "frontend/diagrams/layout/level.hpp"
#include "frontend/diagrams/notation/picture.hpp"

namespace robochart::diagrams {

/// The index that means "no box".
inline constexpr std::size_t no_box = static_cast<std::size_t>(-1);

/// A box, a circle, or the square of a port.
struct SceneBox {
    std::string name;
    layout::Rectangle place;
    std::size_t parent = no_box;   ///< the box that encloses a box
    std::size_t port_of = no_box;  ///< the box on whose border a port is
    bool round = false;
    bool frame = false;  ///< the box contains everything, including lines from the ports on its border
};

/// An edge between two boxes of one level.
struct SceneLine {
    std::string name;
    std::size_t from = 0, to = 0;
    std::vector<layout::Point> points;
    layout::Rectangle label;
};

/// The boxes and lines of a diagram.
struct Scene {
    std::vector<SceneBox> boxes;
    std::vector<SceneLine> lines;
};

/// Returns the scene of a picture.
[[nodiscard]] Scene scene_of(const Picture&);

/// Returns the scene of a level and its placement.
[[nodiscard]] Scene scene_of(const layout::Level&, const layout::Placement&);

/// Returns the violated criteria, one sentence each. Boxes of a level, labels and ports must not overlap. No label may
/// be on a line. Lines must not overlap, except where they join at a common circle or port. No line may cross a box.
/// Every end is on the border of its box. Lines are horizontal and vertical. The contents of a box are within it.
[[nodiscard]] std::vector<std::string> faults_of(const Scene&);

/// Returns the number of crossings of lines.
[[nodiscard]] std::size_t crossings_of(const Scene&);

/// The share of flipped pairs. A pair consists of two boxes (matched by name) that are in the same level of both
/// scenes. It is flipped if its left-right or top-bottom order differs between the scenes.
struct Flips {
    std::size_t pairs = 0, flipped = 0;
};
[[nodiscard]] Flips flips_between(const Scene& before, const Scene& after);

}  // namespace robochart::diagrams
