// SPDX-License-Identifier: Apache-2.0
// See free_space.hpp.
#include "frontend/diagrams/layout/free_space.hpp"

#include <algorithm>
#include <cmath>

namespace robochart::diagrams::layout {
namespace {

/// Returns the length of the intersection of two ranges.
double overlap_length(double a_low, double a_high, double b_low, double b_high) {
    return std::max(0.0, std::min(a_high, b_high) - std::max(a_low, b_low));
}

/// Returns the length of the part of a straight line that is inside a rectangle, by clipping (Liang and Barsky, 1984).
double length_within(const Point& from, const Point& to, const Rectangle& it) {
    double first = 0;
    double last = 1;
    const auto clip = [&](double start, double change, double low, double high) {
        if (change == 0) {
            if (start <= low || start >= high) last = -1;
            return;
        }
        const auto [a, b] = std::minmax({(low - start) / change, (high - start) / change});
        first = std::max(first, a);
        last = std::min(last, b);
    };
    clip(from.x, to.x - from.x, it.x, it.right());
    clip(from.y, to.y - from.y, it.y, it.bottom());
    return last <= first ? 0 : (last - first) * std::hypot(to.x - from.x, to.y - from.y);
}

Rectangle rectangle_around(const Point& a, const Point& b, double margin) {
    const double x = std::min(a.x, b.x);
    const double y = std::min(a.y, b.y);
    return {x - margin, y - margin, std::abs(a.x - b.x) + 2 * margin, std::abs(a.y - b.y) + 2 * margin};
}

}  // namespace

void FreeSpace::add(std::span<const Point> line) {
    for (std::size_t i = 1; i < line.size(); ++i) segments_.push_back({line[i - 1], line[i]});
}

void FreeSpace::add_border(const Rectangle& it) {
    const Point corners[] = {
        {it.x, it.y}, {it.right(), it.y}, {it.right(), it.bottom()}, {it.x, it.bottom()}, {it.x, it.y}};
    add(corners);
}

double FreeSpace::occupied_area(const Rectangle& it) const {
    double result = 0;
    for (const Rectangle& other : rectangles_)
        result += overlap_length(it.x, it.right(), other.x, other.right()) *
                  overlap_length(it.y, it.bottom(), other.y, other.bottom());
    constexpr double line_width = 4;
    for (const Segment& segment : segments_) result += line_width * length_within(segment.from, segment.to, it);
    return result;
}

Rectangle FreeSpace::choose_place(std::span<const Rectangle> places) const {
    Rectangle result = places.front();
    double least = occupied_area(result);
    for (const Rectangle& place : places.subspan(1)) {
        if (least == 0) break;
        if (const double here = occupied_area(place); here < least) {
            least = here;
            result = place;
        }
    }
    return result;
}

bool FreeSpace::is_crossed(std::span<const Point> line) const {
    for (std::size_t i = 1; i < line.size(); ++i)
        for (const Rectangle& box : rectangles_)
            if (length_within(line[i - 1], line[i], box) > 1) return true;
    return false;
}

double FreeSpace::route_cost(const Segment& piece) const {
    constexpr double through_box = 1000;
    constexpr double on_line = 0.5;  // fraction of its length
    constexpr double crossing = 20;
    constexpr double near = 5;
    double result = 0.1 * std::hypot(piece.to.x - piece.from.x, piece.to.y - piece.from.y);
    for (const Rectangle& box : rectangles_)
        if (length_within(piece.from, piece.to, box) > 0.5) result += through_box;
    const Rectangle wide = rectangle_around(piece.from, piece.to, near);
    for (const Segment& other : segments_) {
        const double within = length_within(other.from, other.to, wide);
        if (within > 0) result += crossing + (within > 3 * near ? on_line * within : 0);
    }
    return result;
}

double FreeSpace::route_cost(std::span<const Point> line) const {
    constexpr double bend = 10;
    double result = bend * static_cast<double>(line.size());
    for (std::size_t i = 1; i < line.size(); ++i) result += route_cost(Segment{line[i - 1], line[i]});
    return result;
}

}  // namespace robochart::diagrams::layout
