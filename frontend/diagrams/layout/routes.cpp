// SPDX-License-Identifier: Apache-2.0
// See routes.hpp.
#include "frontend/diagrams/layout/routes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace robochart::diagrams::layout {
namespace {

Point swap_axes(const Point& point) {
    return {point.y, point.x};
}
Rectangle swap_axes(const Rectangle& it) {
    return {it.y, it.x, it.height, it.width};
}

/// Removes points in the middle of straight segments.
std::vector<Point> keep_corners(const std::vector<Point>& points) {
    std::vector<Point> result;
    for (const Point& point : points) {
        if (!result.empty() && result.back() == point) continue;
        if (result.size() > 1) {
            const Point& last = result.back();
            const Point& before = result[result.size() - 2];
            if ((before.x == last.x && last.x == point.x) || (before.y == last.y && last.y == point.y))
                result.pop_back();
        }
        result.push_back(point);
    }
    return result;
}

class Placer {
public:
    explicit Placer(const Graph& graph) : graph_(graph), level_(*graph.level) {}

    Placement place_all() {
        result_.direction = graph_.turned ? Direction::right : Direction::down;
        result_.edges.resize(level_.edges.size());
        for (std::size_t b = 0; b < level_.boxes.size(); ++b) place_box(b);
        for (std::size_t e = 0; e < level_.edges.size(); ++e) place_edge(e);
        for (const Node& node : graph_.nodes)
            if (node.kind == Node::Kind::label) result_.edges[node.edge].label = label_of(node);
        place_loops();
        move_to_origin();
        return std::move(result_);
    }

private:
    [[nodiscard]] double y_of(const Node& node) const { return graph_.layer_y[node.layer]; }

    void place_box(std::size_t b) {
        const Node& node = graph_.nodes[b];
        const double top = y_of(node) - node.above + node.ports_above;
        Rectangle place{node.x - node.before, top, node.before + node.after - node.loops,
                        node.above - node.ports_above + node.below - node.ports_below};
        if (level_.boxes[b].round)
            place = {node.x - node.before, y_of(node) - node.before, 2 * node.before, 2 * node.before};
        PlacedBox box{graph_.turned ? swap_axes(place) : place, {}, {0, node.layer / 2, node.position, 0}};
        for (const GraphPort& port : graph_.ports[b]) {
            const Point centre{port.x, port.down ? place.bottom() : place.y};
            box.ports.push_back({!port.down, swap_axes(centre)});
        }
        result_.boxes.push_back(std::move(box));
    }

    [[nodiscard]] Rectangle label_of(const Node& node) const {
        const Rectangle place{node.x + graph_.label_gap(), y_of(node) - node.above, node.after - graph_.label_gap(),
                              node.above + node.below};
        return graph_.turned ? swap_axes(place) : place;
    }

    /// Returns the y of the border of a box at this x. For a port, this is the side away from the box.
    [[nodiscard]] double border_y(std::size_t n, double x, bool lower) const {
        const Node& node = graph_.nodes[n];
        double reach = lower ? node.below : node.above;
        if (level_.boxes[node.box].round)
            reach = std::sqrt(std::max(0.0, node.before * node.before - (x - node.x) * (x - node.x)));
        return y_of(node) + (lower ? reach : -reach);
    }

    void place_edge(std::size_t e) {
        const auto& chain = graph_.chains[e];
        if (chain.empty()) return;
        const Link& first = graph_.links[chain.front()];
        const Link& last = graph_.links[chain.back()];
        std::vector<Point> points;
        Point at{first.upper_x, border_y(first.upper, first.upper_x, first.turn != Link::Turn::over)};
        points.push_back(at);
        for (const std::size_t l : chain) {
            const Link& link = graph_.links[l];
            if (!graph_.nodes[link.lower].is_box()) result_.edges[e].ranks.push_back(graph_.nodes[link.lower].position);
            for (const Link::Track& track : link.tracks) {
                points.push_back({at.x, track.y});
                at = {track.x, track.y};
                points.push_back(at);
            }
        }
        points.push_back({last.lower_x, border_y(last.lower, last.lower_x, last.turn == Link::Turn::under)});
        points = keep_corners(points);
        if (graph_.reversed[e]) std::ranges::reverse(points);
        if (graph_.turned)
            for (Point& point : points) point = swap_axes(point);
        result_.edges[e].points = std::move(points);
    }

    /// Places loops at the right side of a box, one below the other. Levels with loops are laid out downwards.
    void place_loops() {
        std::vector<std::vector<std::size_t>> loops(level_.boxes.size());
        for (std::size_t e = 0; e < level_.edges.size(); ++e)
            if (graph_.chains[e].empty()) loops[level_.edges[e].from].push_back(e);
        for (std::size_t b = 0; b < level_.boxes.size(); ++b)
            if (!loops[b].empty()) place_loops(b, loops[b]);
    }

    void place_loops(std::size_t b, const std::vector<std::size_t>& loops) {
        const Rectangle& box = result_.boxes[b].place;
        double needed = -loop_gap;
        for (const std::size_t e : loops) needed += loop_height(level_.edges[e].label) + loop_gap;
        double y = box.centre().y - needed / 2;
        for (const std::size_t e : loops) {
            const Size& label = level_.edges[e].label;
            const double height = loop_height(label);
            const double middle = y + height / 2;
            const double reach = box.right() + loop_reach;
            PlacedEdge& edge = result_.edges[e];
            const double above = middle - 5;
            const double below = middle + 5;
            edge.points = {{side_at(b, above), above}, {reach, above}, {reach, below}, {side_at(b, below), below}};
            if (!label.empty())
                edge.label = {reach + distance::label, middle - label.height / 2, label.width, label.height};
            y += height + loop_gap;
        }
    }

    /// Returns the x of the right side of a box at this y.
    [[nodiscard]] double side_at(std::size_t b, double y) const {
        const Rectangle& box = result_.boxes[b].place;
        if (!level_.boxes[b].round) return box.right();
        const double radius = box.width / 2;
        const double away = y - box.centre().y;
        return box.centre().x + std::sqrt(std::max(0.0, radius * radius - away * away));
    }

    void move_to_origin() {
        Point least{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
        Point most{0, 0};
        const auto see = [&](const Point& point) {
            least = {std::min(least.x, point.x), std::min(least.y, point.y)};
            most = {std::max(most.x, point.x), std::max(most.y, point.y)};
        };
        const auto see_all = [&](const Rectangle& it) {
            see({it.x, it.y});
            see({it.right(), it.bottom()});
        };
        for (const PlacedBox& box : result_.boxes) {
            see_all(box.place);
            for (const PlacedPort& port : box.ports)
                see_all({port.centre.x - port_size / 2, port.centre.y - port_size / 2, port_size, port_size});
        }
        for (const PlacedEdge& edge : result_.edges) {
            for (const Point& point : edge.points) see(point);
            if (!edge.label.empty()) see_all(edge.label);
        }
        move_all({-least.x, -least.y});
        result_.size = {most.x - least.x, most.y - least.y};
    }

    void move_all(const Point& by) {
        for (PlacedBox& box : result_.boxes) {
            box.place.x += by.x;
            box.place.y += by.y;
            for (PlacedPort& port : box.ports) port.centre = {port.centre.x + by.x, port.centre.y + by.y};
        }
        for (PlacedEdge& edge : result_.edges) {
            for (Point& point : edge.points) point = {point.x + by.x, point.y + by.y};
            edge.label.x += by.x;
            edge.label.y += by.y;
        }
    }

    const Graph& graph_;
    const Level& level_;
    Placement result_;
};

}  // namespace

Placement placement_of(const Graph& graph) {
    return Placer(graph).place_all();
}

}  // namespace robochart::diagrams::layout
