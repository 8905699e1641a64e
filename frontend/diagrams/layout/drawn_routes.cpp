// SPDX-License-Identifier: Apache-2.0
// See drawn_routes.hpp. An orthogonal route is stored as a list of numbers: the y of its horizontal and the x of its
// vertical segments, in turn. Every list of numbers is an orthogonal route that ends at the borders of its boxes.
#include "frontend/diagrams/layout/drawn_routes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "frontend/diagrams/layout/graph.hpp"

namespace robochart::diagrams::layout {
namespace {

/// A horizontal segment with a given y, or a vertical segment with a given x.
struct DrawnPiece {
    bool horizontal = true;
    double at = 0;
};

struct Range {
    double low = 0, high = 0;
    [[nodiscard]] bool empty() const { return low > high; }
    [[nodiscard]] bool contains(double value) const { return low <= value && value <= high; }
    [[nodiscard]] double middle() const { return (low + high) / 2; }
};

Range overlap_of(const Range& a, const Range& b) {
    return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

/// Returns the range of a box in the direction of a segment.
Range extent_along(const RouteEnd& end, bool horizontal) {
    return horizontal ? Range{end.place.x, end.place.right()} : Range{end.place.y, end.place.bottom()};
}

/// Returns the range in which a segment may end at a box, without the corners.
Range slot_range(const RouteEnd& end, bool horizontal) {
    const Range side = extent_along(end, !horizontal);
    const double half = (side.high - side.low) / 2;
    double reach = std::max(half - 5, half / 2);
    if (end.shape == RouteEnd::Shape::circle) reach = half * 0.7;
    if (end.shape == RouteEnd::Shape::square) reach = 4;
    return {side.middle() - reach, side.middle() + reach};
}

double clamp_to_range(double value, const Range& range) {
    return std::clamp(value, range.low, range.high);
}

/// Removes the segments at the beginning of a route that are inside its box. Moves the first remaining segment into the
/// range in which it may end.
void begin_at(std::vector<DrawnPiece>& pieces, const RouteEnd& end) {
    while (pieces.size() > 1 && extent_along(end, pieces[0].horizontal).contains(pieces[1].at))
        pieces.erase(pieces.begin());
    pieces.front().at = clamp_to_range(pieces.front().at, slot_range(end, pieces.front().horizontal));
}

/// Returns the range of a box along a segment that ends at it.
Range covered_by(const RouteEnd& end, const DrawnPiece& piece) {
    const Range extent = extent_along(end, piece.horizontal);
    if (end.shape != RouteEnd::Shape::circle) return extent;
    const double radius = (extent.high - extent.low) / 2;
    const double off = piece.at - extent_along(end, !piece.horizontal).middle();
    const double half = std::sqrt(std::max(0.0, radius * radius - off * off));
    return {extent.middle() - half, extent.middle() + half};
}

/// Returns the coordinate of the side of a box beyond which `place` is, or no value if it is between the sides.
std::optional<double> side_towards(const Range& extent, double place) {
    if (place >= extent.high) return extent.high;
    if (place <= extent.low) return extent.low;
    return std::nullopt;
}

Point point_at(const DrawnPiece& piece, double along) {
    return piece.horizontal ? Point{along, piece.at} : Point{piece.at, along};
}

/// Returns a route of one segment.
std::vector<Point> straight_route(const DrawnPiece& piece, const RouteEnd& from, const RouteEnd& to) {
    const Range range = overlap_of(slot_range(from, piece.horizontal), slot_range(to, piece.horizontal));
    if (range.empty()) return {};
    const DrawnPiece moved{piece.horizontal, clamp_to_range(piece.at, range)};
    const Range source = covered_by(from, moved);
    const Range target = covered_by(to, moved);
    if (source.high < target.low) return {point_at(moved, source.high), point_at(moved, target.low)};
    if (target.high < source.low) return {point_at(moved, source.low), point_at(moved, target.high)};
    return {};
}

/// Removes points that are not bends.
std::vector<Point> remove_straight_points(const std::vector<Point>& points) {
    constexpr double tiny = 0.01;
    std::vector<Point> result;
    for (const Point& point : points) {
        while (result.size() > 1) {
            const Point& a = result[result.size() - 2];
            const Point& b = result.back();
            const bool on = (std::abs(a.x - b.x) < tiny && std::abs(b.x - point.x) < tiny) ||
                            (std::abs(a.y - b.y) < tiny && std::abs(b.y - point.y) < tiny);
            if (!on) break;
            result.pop_back();
        }
        if (result.empty() || std::hypot(result.back().x - point.x, result.back().y - point.y) >= tiny)
            result.push_back(point);
    }
    return result;
}

/// Returns the points of a route, or an empty result if it does not lead from one box to the other.
std::vector<Point> points_of(std::vector<DrawnPiece> pieces, const RouteEnd& from, const RouteEnd& to) {
    if (pieces.empty()) return {};
    begin_at(pieces, from);
    std::ranges::reverse(pieces);
    begin_at(pieces, to);
    std::ranges::reverse(pieces);
    if (pieces.size() == 1) return straight_route(pieces.front(), from, to);
    const auto start = side_towards(covered_by(from, pieces.front()), pieces[1].at);
    const auto end = side_towards(covered_by(to, pieces.back()), pieces[pieces.size() - 2].at);
    if (!start || !end) return {};
    std::vector<Point> points{point_at(pieces.front(), *start)};
    for (std::size_t i = 1; i < pieces.size(); ++i) points.push_back(point_at(pieces[i - 1], pieces[i].at));
    points.push_back(point_at(pieces.back(), *end));
    return remove_straight_points(points);
}

/// Appends a segment. Consecutive segments of one direction are merged.
void add_piece(std::vector<DrawnPiece>& pieces, const DrawnPiece& piece) {
    if (pieces.empty() || pieces.back().horizontal != piece.horizontal) pieces.push_back(piece);
}

/// True if a line from the first to the second point leaves the box to the left or right.
bool leaves_sideways(const RouteEnd& end, const Point& at, const Point& other) {
    const Rectangle& box = end.place;
    const double x = std::abs(at.x - box.centre().x) * box.height;
    const double y = std::abs(at.y - box.centre().y) * box.width;
    if (x != y) return x > y;
    return std::abs(other.x - at.x) > std::abs(other.y - at.y);
}

/// Returns the positions of the bends between the boxes at their current places.
std::vector<Point> bends_of(const DrawnEdge& edge, const RouteEnd& from, const RouteEnd& to) {
    const auto anchor = [](const Rectangle& box, const Point& share) {
        return Point{box.x + share.x * box.width, box.y + share.y * box.height};
    };
    const Point source = anchor(from.place, edge.source_anchor);
    const Point target = anchor(to.place, edge.target_anchor);
    std::vector<Point> points;
    for (std::size_t i = 0; i < edge.bends.size(); ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(edge.bends.size() - 1);
        const auto& [s, t] = edge.bends[i];
        points.push_back({(source.x + s.x) * (1 - part) + (target.x + t.x) * part,
                          (source.y + s.y) * (1 - part) + (target.y + t.y) * part});
    }
    return points;
}

constexpr double straight_enough = 3;

/// True if the segment that ends at this bend was neither horizontal nor vertical in the drawing.
bool is_askew(const DrawnEdge& edge, std::size_t bend) {
    const Point& a = edge.bends[bend - 1].from_source;
    const Point& b = edge.bends[bend].from_source;
    return std::abs(a.x - b.x) > straight_enough && std::abs(a.y - b.y) > straight_enough;
}

/// Returns the segments of a drawn route. A diagonal segment becomes a corner.
std::vector<DrawnPiece> pieces_of(const DrawnEdge& edge, const std::vector<Point>& points, const RouteEnd& from,
                                  const RouteEnd& to) {
    std::vector<DrawnPiece> pieces;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Point& a = points[i - 1];
        const Point& b = points[i];
        const bool first = i == 1;
        const bool last = i + 1 == points.size();
        const double width = std::abs(edge.bends[i].from_source.x - edge.bends[i - 1].from_source.x);
        const double height = std::abs(edge.bends[i].from_source.y - edge.bends[i - 1].from_source.y);
        if (width <= straight_enough && height <= straight_enough && !(first && last)) continue;
        const auto between = [&](double p, double q) {
            if (first && !last) return p;
            if (last && !first) return q;
            return (p + q) / 2;
        };
        if (!is_askew(edge, i)) {
            const bool flat = width > height;
            add_piece(pieces, {flat, flat ? between(a.y, b.y) : between(a.x, b.x)});
        } else {
            const bool begins = pieces.empty() ? leaves_sideways(from, a, b) : pieces.back().horizontal;
            const bool ends = last ? leaves_sideways(to, b, a) : !begins;
            add_piece(pieces, {begins, begins ? a.y : a.x});
            if (begins == ends) add_piece(pieces, {!begins, begins ? (a.x + b.x) / 2 : (a.y + b.y) / 2});
            add_piece(pieces, {ends, ends ? b.y : b.x});
        }
    }
    return pieces;
}

/// Returns the point at which a straight line from the inside of a rectangle leaves it.
Point exit_of(const Rectangle& box, const Point& inside, const Point& outside) {
    double part = 1;
    const auto see = [&](double start, double change, double low, double high) {
        if (change > 0) part = std::min(part, (high - start) / change);
        if (change < 0) part = std::min(part, (low - start) / change);
    };
    see(inside.x, outside.x - inside.x, box.x, box.right());
    see(inside.y, outside.y - inside.y, box.y, box.bottom());
    return {inside.x + part * (outside.x - inside.x), inside.y + part * (outside.y - inside.y)};
}

bool contains(const Rectangle& box, const Point& point) {
    return box.x <= point.x && point.x <= box.right() && box.y <= point.y && point.y <= box.bottom();
}

/// Makes a diagonal line begin at the border of its box, by clipping it or by extending it to the nearest point of the
/// border.
void begin_oblique(std::vector<Point>& points, const RouteEnd& end) {
    const Rectangle& box = end.place;
    if (end.shape != RouteEnd::Shape::box) {
        const Point next = points[1];
        const double length = std::hypot(next.x - box.centre().x, next.y - box.centre().y);
        if (length < 1) return;
        const double part = box.width / 2 / length;
        points.front() = {box.centre().x + (next.x - box.centre().x) * part,
                          box.centre().y + (next.y - box.centre().y) * part};
        return;
    }
    while (points.size() > 2 && contains(box, points[1])) points.erase(points.begin());
    if (contains(box, points.front()))
        points.front() = exit_of(box, points.front(), points[1]);
    else
        points.insert(points.begin(),
                      {std::clamp(points[0].x, box.x, box.right()), std::clamp(points[0].y, box.y, box.bottom())});
}

std::vector<Point> make_oblique(std::vector<Point> points, const RouteEnd& from, const RouteEnd& to) {
    if (from.place == to.place && points.size() < 4) return {};
    begin_oblique(points, from);
    std::ranges::reverse(points);
    begin_oblique(points, to);
    std::ranges::reverse(points);
    return points;
}

/// Returns possible positions of an end on a side. The middle comes first.
std::vector<double> positions_to_try(const Range& range) {
    const double step = (range.high - range.low) / 4;
    if (step < 3) return {range.middle()};
    return {range.middle(), range.low + step, range.high - step, range.low, range.high};
}

/// Returns possible positions of the middle one of three segments.
std::vector<double> middle_positions(const Range& a, const Range& b) {
    std::vector<double> places;
    if (a.high < b.low || b.high < a.low) {
        const Range gap = a.high < b.low ? Range{a.high, b.low} : Range{b.high, a.low};
        for (const double part : {0.5, 0.3, 0.7}) places.push_back(gap.low + part * (gap.high - gap.low));
    }
    for (const double times : {1.0, 1.7, 2.4}) {
        places.push_back(std::max(a.high, b.high) + loop_reach * times);
        places.push_back(std::min(a.low, b.low) - loop_reach * times);
    }
    return places;
}

}  // namespace

std::vector<Point> route_as_drawn(const DrawnEdge& edge, const RouteEnd& from, const RouteEnd& to) {
    if (edge.bends.size() < 2) return {};
    const bool stored = std::ranges::any_of(
        edge.bends, [&](const DrawnEdge::Bend& bend) { return bend.from_source != edge.bends.front().from_source; });
    if (!stored) return {};
    const std::vector<Point> points = bends_of(edge, from, to);
    if (edge.right_angled && edge.bends.size() == 2 && is_askew(edge, 1)) return {};
    return edge.right_angled ? points_of(pieces_of(edge, points, from, to), from, to) : make_oblique(points, from, to);
}

std::vector<Point> new_route(const RouteEnd& from, const RouteEnd& to, const FreeSpace& space) {
    std::vector<Point> best;
    double least = std::numeric_limits<double>::infinity();
    const auto see = [&](std::vector<DrawnPiece> pieces) {
        std::vector<Point> points = points_of(std::move(pieces), from, to);
        if (points.size() < 2) return;
        if (const double cost = space.route_cost(points); cost < least) {
            least = cost;
            best = std::move(points);
        }
    };
    const bool loop = from.place == to.place;
    for (const bool horizontal : {true, false}) {
        const Range common = overlap_of(slot_range(from, horizontal), slot_range(to, horizontal));
        if (!loop && !common.empty())
            for (const double at : positions_to_try(common)) see({{horizontal, at}});
        for (const double first : positions_to_try(slot_range(from, horizontal))) {
            if (loop)  // around a corner
                see({{horizontal, first},
                     {!horizontal, extent_along(from, horizontal).high + loop_reach},
                     {horizontal, extent_along(from, !horizontal).high + loop_reach},
                     {!horizontal, slot_range(from, !horizontal).middle()}});
            else
                for (const double last : positions_to_try(slot_range(to, !horizontal)))
                    see({{horizontal, first}, {!horizontal, last}});
            for (const double last : positions_to_try(slot_range(to, horizontal))) {
                if (loop && last <= first) continue;
                for (const double at : middle_positions(extent_along(from, horizontal), extent_along(to, horizontal)))
                    see({{horizontal, first}, {!horizontal, at}, {horizontal, last}});
            }
        }
    }
    if (best.empty()) best = {from.place.centre(), to.place.centre()};
    return best;
}

}  // namespace robochart::diagrams::layout
