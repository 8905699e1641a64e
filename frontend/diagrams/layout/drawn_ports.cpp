// SPDX-License-Identifier: Apache-2.0
// See drawn_ports.hpp.
#include "frontend/diagrams/layout/drawn_ports.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "frontend/diagrams/layout/graph.hpp"

namespace robochart::diagrams::layout {
namespace {

constexpr double half_port = port_size / 2;

/// Returns the side of a box that is nearest to a point. If the point is outside the box, this is a side beyond which
/// the point is.
Side side_of(const Point& place, const Size& size) {
    const std::array<double, 4> inside{place.x, size.width - place.x, place.y, size.height - place.y};
    const auto nearest = std::ranges::min_element(inside);
    return static_cast<Side>(nearest - inside.begin());
}

double on_side(double place, double length) {
    const double margin = std::min(half_port + 1, length / 2);
    return std::clamp(place, margin, length - margin);
}

/// Returns the centre of a square on a side of a box.
Point port_centre(const Rectangle& box, Side side, double along) {
    switch (side) {
        case Side::left:
            return {box.x, box.y + on_side(along, box.height)};
        case Side::right:
            return {box.right(), box.y + on_side(along, box.height)};
        case Side::top:
            return {box.x + on_side(along, box.width), box.y};
        case Side::bottom:
            return {box.x + on_side(along, box.width), box.bottom()};
    }
    return {};
}

/// Moves a square outwards if it would cover the title.
Point beside_title(const Point& centre, Side side, const Rectangle& title) {
    constexpr double gap = 1;
    if (title.empty() || !rectangles_overlap(square_at(centre), title)) return centre;
    switch (side) {
        case Side::left:
            return {title.x - gap - half_port, centre.y};
        case Side::right:
            return {title.right() + gap + half_port, centre.y};
        case Side::top:
            return {centre.x, title.y - gap - half_port};
        case Side::bottom:
            return {centre.x, title.bottom() + gap + half_port};
    }
    return centre;
}

Point place_port(const Rectangle& box, double header, const DrawnPorts& drawn, const Point& centre) {
    const Size size{drawn.owner.width > 0 ? drawn.owner.width : box.width,
                    drawn.owner.height > 0 ? drawn.owner.height : box.height};
    const Side side = side_of(centre, size);
    const bool upright = side == Side::left || side == Side::right;
    const double moved = centre.y >= drawn.header ? header - drawn.header : 0;
    const Rectangle title{box.centre().x + drawn.title.x, box.y + drawn.title.y, drawn.title.width, drawn.title.height};
    return beside_title(port_centre(box, side, upright ? centre.y + moved : centre.x), side, title);
}

/// Returns the next free place on the right side, from a given y downwards, or the last place if the side is full.
Point free_port(const Rectangle& box, double& from, const std::vector<PlacedPort>& ports) {
    Point centre{box.right(), from};
    const auto taken = [&](const PlacedPort& port) {
        return std::abs(port.centre.x - centre.x) < distance::ports &&
               std::abs(port.centre.y - centre.y) < distance::ports;
    };
    while (std::ranges::any_of(ports, taken)) centre.y += distance::ports;
    from = centre.y + distance::ports;
    centre.y = std::min(centre.y, box.bottom() - half_port);
    return centre;
}

/// Returns the possible places for the label of a square. Those on the side of the drawn label come first.
std::vector<Rectangle> label_places(const Point& centre, const Size& label, Side first) {
    constexpr double gap = 4;
    const double left = centre.x - half_port - gap - label.width;
    const double right = centre.x + half_port + gap;
    const double above = centre.y - half_port - label.height - 1;
    const double below = centre.y + half_port + 1;
    const double middle_x = centre.x - label.width / 2;
    const double middle_y = centre.y - label.height / 2;
    const std::array<std::vector<Point>, 4> sides{
        {{{left, middle_y}, {left, above}, {left, below}, {left, above - label.height}, {left, below + label.height}},
         {{right, middle_y},
          {right, above},
          {right, below},
          {right, above - label.height},
          {right, below + label.height}},
         {{centre.x + 1, above},
          {middle_x, above},
          {centre.x - label.width - 1, above},
          {middle_x, above - label.height}},
         {{centre.x + 1, below},
          {middle_x, below},
          {centre.x - label.width - 1, below},
          {middle_x, below + label.height}}}};
    std::vector<Rectangle> places;
    const auto add = [&](std::size_t side) {
        for (const Point& corner : sides[side]) places.push_back({corner.x, corner.y, label.width, label.height});
    };
    add(static_cast<std::size_t>(first));
    for (const Side side : {Side::right, Side::left, Side::top, Side::bottom})
        if (side != first) add(static_cast<std::size_t>(side));
    return places;
}

Side label_side(const DrawnPorts& drawn, std::size_t port, const PlacedPort& placed) {
    if (drawn.ports[port]) return drawn.ports[port]->label;
    return placed.left ? Side::left : Side::right;
}

}  // namespace

Rectangle square_at(const Point& centre) {
    return {centre.x - half_port, centre.y - half_port, port_size, port_size};
}

std::vector<PlacedPort> squares_of(const Rectangle& box, double header, const DrawnPorts& drawn) {
    std::vector<PlacedPort> placed(drawn.ports.size());
    std::vector<PlacedPort> known;
    for (std::size_t p = 0; p < placed.size(); ++p) {
        if (!drawn.ports[p]) continue;
        placed[p].centre = place_port(box, header, drawn, drawn.ports[p]->centre);
        known.push_back(placed[p]);
    }
    double free = box.y + std::min(header, box.height) + distance::port_margin;
    for (std::size_t p = 0; p < placed.size(); ++p) {
        if (!drawn.ports[p]) placed[p].centre = free_port(box, free, known);
        placed[p].left = placed[p].centre.x < box.centre().x;
    }
    return placed;
}

void label_ports(std::vector<PlacedPort>& ports, const DrawnPorts& drawn, FreeSpace& space) {
    for (std::size_t p = 0; p < ports.size(); ++p) {
        if (drawn.labels[p].empty()) continue;
        ports[p].label =
            space.choose_place(label_places(ports[p].centre, drawn.labels[p], label_side(drawn, p, ports[p])));
        space.add(*ports[p].label);
    }
}

std::vector<PlacedPort> ports_as_drawn(const Rectangle& box, double header, const DrawnPorts& drawn) {
    std::vector<PlacedPort> placed = squares_of(box, header, drawn);
    FreeSpace space;
    space.add(box);
    for (const PlacedPort& port : placed) space.add(square_at(port.centre));
    label_ports(placed, drawn, space);
    return placed;
}

}  // namespace robochart::diagrams::layout
