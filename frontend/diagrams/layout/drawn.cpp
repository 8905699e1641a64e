// SPDX-License-Identifier: Apache-2.0
// See drawn.hpp.
#include "frontend/diagrams/layout/drawn.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "frontend/diagrams/layout/arrange.hpp"
#include "frontend/diagrams/layout/drawn_ports.hpp"
#include "frontend/diagrams/layout/drawn_routes.hpp"
#include "frontend/diagrams/layout/free_space.hpp"
#include "frontend/diagrams/layout/graph.hpp"

namespace robochart::diagrams::layout {
namespace {

constexpr double inset = 5;  ///< distance between the border of a level and its contents
constexpr double apart = 8;  ///< distance between boxes that were drawn closer to each other, or that have grown

/// Returns the point in the middle of a line.
Point middle_of(const std::vector<Point>& line) {
    const auto length = [&](std::size_t i) { return std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y); };
    double rest = 0;
    for (std::size_t i = 1; i < line.size(); ++i) rest += length(i) / 2;
    for (std::size_t i = 1; i < line.size(); ++i) {
        if (rest <= length(i) && length(i) > 0) {
            const double part = rest / length(i);
            return {line[i - 1].x + part * (line[i].x - line[i - 1].x),
                    line[i - 1].y + part * (line[i].y - line[i - 1].y)};
        }
        rest -= length(i);
    }
    return line.back();
}

/// Adds places for a label next to a segment of a line.
void add_places_beside(const Point& a, const Point& b, const Size& label, std::vector<Rectangle>& places) {
    for (const double part : {0.5, 0.3, 0.7, 0.15, 0.85}) {
        const Point at{a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
        if (std::abs(b.x - a.x) > std::abs(b.y - a.y)) {
            const double x = at.x - label.width / 2;
            places.push_back({x, at.y - distance::label_below - label.height, label.width, label.height});
            places.push_back({x, at.y + distance::label_below, label.width, label.height});
        } else {
            const double y = at.y - label.height / 2;
            places.push_back({at.x + distance::label, y, label.width, label.height});
            places.push_back({at.x - distance::label - label.width, y, label.width, label.height});
        }
    }
}

std::vector<Rectangle> label_places(const std::vector<Point>& line, const Size& label, const Point* offset) {
    std::vector<Rectangle> places;
    const Point middle = middle_of(line);
    constexpr double far = 25;  // a reader cannot assign a label that is farther away to its line
    if (offset != nullptr && std::abs(offset->x) < label.width / 2 + far &&
        std::abs(offset->y) < label.height / 2 + far)
        places.push_back({middle.x + offset->x - label.width / 2, middle.y + offset->y - label.height / 2, label.width,
                          label.height});
    std::vector<std::size_t> pieces;
    for (std::size_t i = 1; i < line.size(); ++i) pieces.push_back(i);
    const auto length = [&](std::size_t i) { return std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y); };
    std::ranges::stable_sort(pieces, [&](std::size_t a, std::size_t b) { return length(a) > length(b); });
    for (const std::size_t i : pieces) add_places_beside(line[i - 1], line[i], label, places);
    // The last candidates are places farther above and below.
    for (const double away : {16.0, 32.0, 48.0, 64.0, 96.0, 128.0})
        for (const double part : {0.5, 0.1, 0.9}) {
            const double x = middle.x - part * label.width;
            places.push_back({x, middle.y - away - label.height, label.width, label.height});
            places.push_back({x, middle.y + away, label.width, label.height});
        }
    return places;
}

/// The bounding box of everything in a placement.
class Extent {
public:
    void include_point(const Rectangle& it) {
        low_ = {std::min(low_.x, it.x), std::min(low_.y, it.y)};
        high_ = {std::max(high_.x, it.right()), std::max(high_.y, it.bottom())};
    }
    void include_point(const Point& point) { include_point(Rectangle{point.x, point.y, 0, 0}); }
    [[nodiscard]] const Point& low() const { return low_; }
    [[nodiscard]] const Point& high() const { return high_; }

private:
    Point low_{0, 0}, high_{0, 0};
};

class DrawnArrangement {
public:
    DrawnArrangement(const Level& level, const DrawnLevel& drawn, diagnostics::Budget* budget)
        : level_(level), drawn_(drawn), budget_(budget) {}

    /// Returns the placement moved by a vector. The size of the level is at least `least`.
    Placement place_level(const Point& by, const Size& least) {
        placement_ = {};
        placement_.boxes.resize(level_.boxes.size());
        placement_.edges.resize(level_.edges.size());
        placement_.size = least;
        lines_ = {};
        labels_ = {};
        place_boxes(by);
        place_new_boxes(by);
        place_ports();
        route_edges();
        write_labels();
        return std::move(placement_);
    }

private:
    /// Returns the width and height that a box must gain compared with the drawing.
    [[nodiscard]] Size growth_of(std::size_t b) const {
        if (!drawn_.boxes[b] || level_.boxes[b].round) return {};
        const DrawnBox& drawn = *drawn_.boxes[b];
        const Size& least = level_.boxes[b].size;
        return {drawn.width ? std::max(0.0, least.width - *drawn.width) : 0,
                drawn.height ? std::max(0.0, least.height - *drawn.height) : 0};
    }

    /// Returns the distances by which the boxes move right and down, because boxes to their left or above them have
    /// grown.
    [[nodiscard]] std::vector<Point> compute_shifts() const {
        std::vector<Point> result(level_.boxes.size());
        push_apart(result, &Point::x, &Size::width, &DrawnBox::width);
        push_apart(result, &Point::y, &Size::height, &DrawnBox::height);
        return result;
    }

    void push_apart(std::vector<Point>& shifts, double Point::*start, double Size::*growth,
                    std::optional<double> DrawnBox::*length) const {
        std::vector<std::size_t> order;
        for (std::size_t b = 0; b < level_.boxes.size(); ++b)
            if (drawn_.boxes[b]) order.push_back(b);
        const auto begin = [&](std::size_t b) { return (*drawn_.boxes[b]).corner.*start; };
        std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return begin(a) < begin(b); });
        std::vector<std::size_t> grown;
        for (const std::size_t b : order) {
            if (budget_ != nullptr) budget_->poll();
            for (const std::size_t a : grown)
                if (begin(a) + ((*drawn_.boxes[a]).*length).value_or(0) <= begin(b))
                    shifts[b].*start = std::max(shifts[b].*start, shifts[a].*start + growth_of(a).*growth);
            if (growth_of(b).*growth > 0 || shifts[b].*start > 0) grown.push_back(b);
        }
    }

    void place_boxes(const Point& by) {
        const std::vector<Point> shifted = compute_shifts();
        for (std::size_t b = 0; b < level_.boxes.size(); ++b) {
            const Box& box = level_.boxes[b];
            if (box.on_border || !drawn_.boxes[b]) continue;
            const DrawnBox& drawn = *drawn_.boxes[b];
            Rectangle place{drawn.corner.x + by.x + shifted[b].x, drawn.corner.y + by.y + shifted[b].y,
                            drawn.width.value_or(box.size.width), drawn.height.value_or(box.size.height)};
            if (box.round) {
                const Point middle = place.centre();
                place = {middle.x - box.size.width / 2, middle.y - box.size.height / 2, box.size.width,
                         box.size.height};
            } else {
                place.width = std::max(place.width, box.size.width);
                place.height = std::max(place.height, box.size.height);
            }
            placement_.boxes[b].place = place;
        }
        separate();
    }

    /// Separates boxes that touch or overlap. The box farther from the upper left corner of the drawing moves right or
    /// down, whichever distance is shorter.
    void separate() {
        std::vector<std::size_t> order;
        for (std::size_t b = 0; b < level_.boxes.size(); ++b)
            if (!level_.boxes[b].on_border && drawn_.boxes[b]) order.push_back(b);
        const auto corner = [&](std::size_t b) { return drawn_.boxes[b]->corner.x + drawn_.boxes[b]->corner.y; };
        std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return corner(a) < corner(b); });
        for (std::size_t i = 0; i < order.size(); ++i) {
            if (budget_ != nullptr) budget_->poll();
            Rectangle& place = placement_.boxes[order[i]].place;
            for (std::size_t moves = 0; moves <= i; ++moves)
                if (!make_space(std::span(order).first(i), place)) break;
            grow_to_include(place);
        }
    }

    /// Moves a box away from the first box that is too near. Returns false if there is none. A box that has moved past
    /// another box never moves back to it.
    [[nodiscard]] bool make_space(std::span<const std::size_t> others, Rectangle& place) const {
        constexpr double rounding = 0.001;
        for (const std::size_t other : others) {
            const Rectangle& fixed = placement_.boxes[other].place;
            if (!rectangles_overlap(fixed, place, rounding - apart)) continue;
            const double right = fixed.right() + apart - place.x;
            const double down = fixed.bottom() + apart - place.y;
            if (right < down)
                place.x += right;
            else
                place.y += down;
            return true;
        }
        return false;
    }

    void grow_to_include(const Rectangle& place) {
        placement_.size.width = std::max(placement_.size.width, place.right() + inset);
        placement_.size.height = std::max(placement_.size.height, place.bottom() + inset);
    }

    /// Lays out the boxes that are not in the drawing separately, and places them below the others.
    void place_new_boxes(const Point& by) {
        Level fresh;
        fresh.direction = level_.direction;
        std::vector<std::size_t> boxes, edges;
        std::vector<std::size_t> number(level_.boxes.size(), nothing);
        bool any = false;
        double bottom = 0;
        for (std::size_t b = 0; b < level_.boxes.size(); ++b) {
            if (level_.boxes[b].on_border) continue;
            if (drawn_.boxes[b]) {
                any = true;
                bottom = std::max(bottom, placement_.boxes[b].place.bottom());
                continue;
            }
            number[b] = boxes.size();
            boxes.push_back(b);
            fresh.boxes.push_back(level_.boxes[b]);
            fresh.boxes.back().pin = Pin::none;
        }
        if (boxes.empty()) return;
        for (std::size_t e = 0; e < level_.edges.size(); ++e) {
            Edge edge = level_.edges[e];
            if (number[edge.from] == nothing || number[edge.to] == nothing) continue;
            edge.from = number[edge.from];
            edge.to = number[edge.to];
            edges.push_back(e);
            fresh.edges.push_back(std::move(edge));
        }
        take_over(arrange_level(fresh, budget_), boxes, edges,
                  {inset + by.x, any ? bottom + distance::boxes : inset + by.y});
    }

    void take_over(Placement fresh, const std::vector<std::size_t>& boxes, const std::vector<std::size_t>& edges,
                   const Point& by) {
        for (std::size_t b = 0; b < boxes.size(); ++b) {
            PlacedBox& box = placement_.boxes[boxes[b]] = std::move(fresh.boxes[b]);
            box.place.x += by.x;
            box.place.y += by.y;
            for (PlacedPort& port : box.ports) port.centre = {port.centre.x + by.x, port.centre.y + by.y};
            grow_to_include(box.place);
        }
        for (std::size_t e = 0; e < edges.size(); ++e) {
            PlacedEdge& edge = placement_.edges[edges[e]] = std::move(fresh.edges[e]);
            for (Point& point : edge.points) point = {point.x + by.x, point.y + by.y};
            edge.label.x += by.x;
            edge.label.y += by.y;
        }
    }

    [[nodiscard]] Rectangle frame_rectangle() const {
        return {0, -drawn_.header, placement_.size.width, placement_.size.height + drawn_.header};
    }

    void place_ports() {
        DrawnPorts border;
        std::vector<std::size_t> owners;
        for (std::size_t b = 0; b < level_.boxes.size(); ++b) {
            PlacedBox& placed = placement_.boxes[b];
            const DrawnPorts& drawn = drawn_.ports[b];
            if (level_.boxes[b].on_border) {
                border.title = drawn.title;
                border.owner = drawn.owner;
                border.header = drawn.header;
                border.ports.push_back(drawn.ports.front());
                owners.push_back(b);
            } else if (drawn_.boxes[b]) {
                placed.ports = squares_of(placed.place, level_.boxes[b].port_start, drawn);
            }
        }
        const std::vector<PlacedPort> squares = squares_of(frame_rectangle(), drawn_.header, border);
        for (std::size_t i = 0; i < owners.size(); ++i) {
            placement_.boxes[owners[i]].ports = {squares[i]};
            placement_.boxes[owners[i]].place = square_at(squares[i].centre);
        }
    }

    [[nodiscard]] RouteEnd end_of(std::size_t box, const std::optional<std::size_t>& port) const {
        using Shape = RouteEnd::Shape;
        if (port) return {square_at(placement_.boxes[box].ports[*port].centre), Shape::square};
        return {placement_.boxes[box].place, level_.boxes[box].round ? Shape::circle : Shape::box};
    }

    void add_line(const std::vector<Point>& line) {
        lines_.add(line);
        labels_.add(line);
    }

    /// Routes the edges. Drawn routes come first, and new routes avoid them. A drawn route that crosses boxes is
    /// replaced by a better route.
    void route_edges() {
        for (std::size_t b = 0; b < level_.boxes.size(); ++b) {
            if (level_.boxes[b].on_border) continue;
            lines_.add(placement_.boxes[b].place);
            lines_.add_border(placement_.boxes[b].place);
        }
        lines_.add_border(frame_rectangle());
        std::vector<std::size_t> missing;
        for (std::size_t e = 0; e < level_.edges.size(); ++e) {
            if (budget_ != nullptr) budget_->poll();
            const Edge& edge = level_.edges[e];
            PlacedEdge& placed = placement_.edges[e];
            if (placed.points.empty() && drawn_.edges[e])
                placed.points =
                    route_as_drawn(*drawn_.edges[e], end_of(edge.from, edge.from_port), end_of(edge.to, edge.to_port));
            if (placed.points.size() < 2 || lines_.is_crossed(placed.points))
                missing.push_back(e);
            else
                add_line(placed.points);
        }
        for (const std::size_t e : missing) {
            if (budget_ != nullptr) budget_->poll();
            const Edge& edge = level_.edges[e];
            std::vector<Point>& points = placement_.edges[e].points;
            std::vector<Point> better =
                new_route(end_of(edge.from, edge.from_port), end_of(edge.to, edge.to_port), lines_);
            if (points.size() < 2 || lines_.route_cost(better) < lines_.route_cost(points)) points = std::move(better);
            add_line(points);
        }
    }

    /// Places the labels. Labels of edges come first, because squares have more possible places for their labels.
    void write_labels() {
        for (std::size_t b = 0; b < level_.boxes.size(); ++b) add_box(b);
        const Rectangle header{0, -drawn_.header, placement_.size.width, drawn_.header};
        lines_.add(header);
        labels_.add(header);
        labels_.add_border(frame_rectangle());
        label_edges();
        for (std::size_t b = 0; b < level_.boxes.size(); ++b) {
            if (budget_ != nullptr) budget_->poll();
            if (!drawn_.boxes[b] && !level_.boxes[b].on_border) continue;
            label_ports(placement_.boxes[b].ports, drawn_.ports[b], labels_);
        }
    }

    /// Adds a box as an obstacle. The label of a square may be inside a box that has free space.
    void add_box(std::size_t b) {
        const PlacedBox& box = placement_.boxes[b];
        for (const PlacedPort& port : box.ports) {
            lines_.add(square_at(port.centre));
            labels_.add(square_at(port.centre));
        }
        if (level_.boxes[b].on_border) return;
        const bool full = box.ports.empty() || drawn_.ports[b].full || !drawn_.boxes[b];
        const double taken = full ? box.place.height : level_.boxes[b].port_start;
        labels_.add(Rectangle{box.place.x, box.place.y, box.place.width, taken});
        labels_.add_border(box.place);
    }

    void label_edges() {
        for (std::size_t e = 0; e < level_.edges.size(); ++e) {
            if (budget_ != nullptr) budget_->poll();
            const Size& size = level_.edges[e].label;
            PlacedEdge& placed = placement_.edges[e];
            if (size.empty()) continue;
            const std::optional<DrawnEdge>& drawn = drawn_.edges[e];
            const Point* offset = drawn && drawn->label ? &*drawn->label : nullptr;
            placed.label = lines_.choose_place(label_places(placed.points, size, offset));
            lines_.add(placed.label);
            labels_.add(placed.label);
        }
    }

    const Level& level_;
    const DrawnLevel& drawn_;
    diagnostics::Budget* budget_;
    Placement placement_;
    FreeSpace lines_;   ///< obstacles of lines and of edge labels
    FreeSpace labels_;  ///< obstacles of labels of squares
};

}  // namespace

Placement arrange_as_drawn(const Level& level, const DrawnLevel& drawn, diagnostics::Budget* budget) {
    DrawnArrangement arrangement(level, drawn, budget);
    Placement first = arrangement.place_level({0, 0}, drawn.size);
    // The bounding box of lines and labels, which may extend beyond the boxes.
    Extent extent;
    for (std::size_t b = 0; b < level.boxes.size(); ++b) {
        if (level.boxes[b].on_border) continue;
        extent.include_point(first.boxes[b].place);
        // Squares on the upper side must not cover the title above the level.
        for (const PlacedPort& port : first.boxes[b].ports)
            extent.include_point(Point{first.boxes[b].place.x, square_at(port.centre).y});
    }
    for (const PlacedEdge& edge : first.edges) {
        // The ends are at boxes, which are included already. Bends above the level lead to squares of the enclosing
        // box.
        for (std::size_t i = 1; i + 1 < edge.points.size(); ++i)
            if (edge.points[i].y >= 0) extent.include_point(edge.points[i]);
        if (!edge.label.empty()) extent.include_point(edge.label);
    }
    const Point by{extent.low().x < 0 ? inset - extent.low().x : 0, extent.low().y < 0 ? inset - extent.low().y : 0};
    const Size least{std::max(first.size.width, extent.high().x + inset) + by.x,
                     std::max(first.size.height, extent.high().y + inset) + by.y};
    if (by == Point{} && least == first.size) return first;
    return arrangement.place_level(by, least);
}

}  // namespace robochart::diagrams::layout
