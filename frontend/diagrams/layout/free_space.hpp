// SPDX-License-Identifier: Apache-2.0
// Records the occupied places of a level, to find free places for text and lines.
#pragma once

#include <span>
#include <vector>

#include "frontend/diagrams/layout/geometry.hpp"

namespace robochart::diagrams::layout {

/// Rectangles and lines that new elements avoid if possible.
class FreeSpace {
public:
    void add(const Rectangle& taken) { rectangles_.push_back(taken); }
    /// Adds a line through these points.
    void add(std::span<const Point> line);
    /// Adds the border of a rectangle without its inside.
    void add_border(const Rectangle& it);

    /// Returns the occupied area of the rectangle, or 0 if it is free.
    [[nodiscard]] double occupied_area(const Rectangle& it) const;
    /// Returns the first free place or, if all are occupied, the least occupied place. `places` must not be empty.
    [[nodiscard]] Rectangle choose_place(std::span<const Rectangle> places) const;
    /// True if the line crosses one of the rectangles.
    [[nodiscard]] bool is_crossed(std::span<const Point> line) const;
    /// Returns the cost of a line of horizontal and vertical segments. Crossed boxes cost most. Crossed or overlapping
    /// lines, bends, and the length of the line cost less.
    [[nodiscard]] double route_cost(std::span<const Point> line) const;

private:
    struct Segment {
        Point from, to;
    };
    [[nodiscard]] double route_cost(const Segment& piece) const;

    std::vector<Rectangle> rectangles_;
    std::vector<Segment> segments_;
};

}  // namespace robochart::diagrams::layout
