// What is already on a level, to find places for text and lines where nothing else is.
#pragma once

#include <span>
#include <vector>

#include "diagrams/layout/geometry.hpp"

namespace robochart::diagrams::layout {

/// Rectangles and lines that something new keeps off, as far as possible.
class FreeSpace {
public:
    void add(const Rectangle& taken) { rectangles_.push_back(taken); }
    /// A line from point to point.
    void add(std::span<const Point> line);
    /// The border of a rectangle, but not what is in it.
    void add_border(const Rectangle& it);

    /// How much is in a rectangle: 0 where nothing is.
    [[nodiscard]] double taken(const Rectangle& it) const;
    /// The first place with nothing on it; where there is none, the one with the least. There is at least one place.
    [[nodiscard]] Rectangle best(std::span<const Rectangle> places) const;
    /// Does a line go through one of the rectangles?
    [[nodiscard]] bool is_crossed(std::span<const Point> line) const;
    /// What a line of horizontal and vertical pieces costs: boxes that it goes through above all, then lines that it
    /// runs on or crosses, its bends and its length.
    [[nodiscard]] double cost(std::span<const Point> line) const;

private:
    struct Segment {
        Point from, to;
    };
    [[nodiscard]] double cost(const Segment& piece) const;

    std::vector<Rectangle> rectangles_;
    std::vector<Segment> segments_;
};

}  // namespace robochart::diagrams::layout
