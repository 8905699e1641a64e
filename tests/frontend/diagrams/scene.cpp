// SPDX-License-Identifier: Apache-2.0
#include "tests/frontend/diagrams/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace robochart::diagrams {
namespace {

using layout::Point;
using layout::Rectangle;

/// A straight segment of a line.
struct Segment {
    std::size_t line = 0;
    double low_x = 0, high_x = 0, low_y = 0, high_y = 0;
    [[nodiscard]] bool horizontal() const { return low_y == high_y; }
};

std::vector<Segment> segments_of(const Scene& scene) {
    std::vector<Segment> segments;
    for (std::size_t l = 0; l < scene.lines.size(); ++l)
        for (std::size_t i = 1; i < scene.lines[l].points.size(); ++i) {
            const Point& a = scene.lines[l].points[i - 1];
            const Point& b = scene.lines[l].points[i];
            segments.push_back({l, std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y), std::max(a.y, b.y)});
        }
    return segments;
}

/// Returns true if the segment goes through the interior, more than `margin` from the border.
bool through(const Segment& segment, const Rectangle& it, double margin) {
    return segment.low_x < it.right() - margin && segment.high_x > it.x + margin &&
           segment.low_y < it.bottom() - margin && segment.high_y > it.y + margin;
}

class Critic {
public:
    explicit Critic(const Scene& scene) : scene_(scene), segments_(segments_of(scene)) {}

    std::vector<std::string> judge() {
        boxes_apart();
        labels_free();
        lines_apart();
        lines_around_boxes();
        ends_on_borders();
        for (const Segment& segment : segments_)
            if (segment.low_x != segment.high_x && segment.low_y != segment.high_y)
                complain("{} is neither horizontal nor vertical", name(segment));
        return std::move(faults_);
    }

private:
    template <typename... Arguments>
    void complain(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        faults_.push_back(fmt::format(format, std::forward<Arguments>(arguments)...));
    }
    [[nodiscard]] const std::string& name(const Segment& segment) const { return scene_.lines[segment.line].name; }

    [[nodiscard]] bool contains(std::size_t outer, std::size_t inner) const {
        for (; inner != no_box; inner = scene_.boxes[inner].parent)
            if (inner == outer) return true;
        return false;
    }
    /// Returns true if one box contains the other, or is a port on its border or on the border of a box inside it.
    [[nodiscard]] bool belong_together(std::size_t a, std::size_t b) const {
        const std::size_t owner_a = scene_.boxes[a].port_of;
        const std::size_t owner_b = scene_.boxes[b].port_of;
        if (owner_a != no_box && owner_b != no_box) return false;
        if (owner_a != no_box) return contains(b, owner_a);
        if (owner_b != no_box) return contains(a, owner_b);
        return contains(a, b) || contains(b, a);
    }

    void boxes_apart() {
        for (std::size_t a = 0; a < scene_.boxes.size(); ++a)
            for (std::size_t b = 0; b < scene_.boxes.size(); ++b) {
                const SceneBox& first = scene_.boxes[a];
                const SceneBox& second = scene_.boxes[b];
                if (a < b && !belong_together(a, b) && layout::rectangles_overlap(first.place, second.place, 0.01))
                    complain("boxes {} and {} overlap", first.name, second.name);
                if (second.parent == a &&
                    (second.place.x < first.place.x || second.place.right() > first.place.right() ||
                     second.place.y < first.place.y || second.place.bottom() > first.place.bottom()))
                    complain("box {} is not within {}", second.name, first.name);
            }
    }

    void labels_free() {
        for (std::size_t l = 0; l < scene_.lines.size(); ++l) {
            const SceneLine& line = scene_.lines[l];
            if (line.label.empty()) continue;
            for (std::size_t other = 0; other < l; ++other)
                if (!scene_.lines[other].label.empty() &&
                    layout::rectangles_overlap(line.label, scene_.lines[other].label, 0.01))
                    complain("labels of {} and {} overlap", line.name, scene_.lines[other].name);
            for (std::size_t b = 0; b < scene_.boxes.size(); ++b)
                if (!contains(b, parent_of(line)) &&
                    layout::rectangles_overlap(line.label, scene_.boxes[b].place, 0.01))
                    complain("label of {} is on box {}", line.name, scene_.boxes[b].name);
            for (const Segment& segment : segments_)
                if (through(segment, line.label, 0.01)) complain("label of {} is on {}", line.name, name(segment));
        }
    }

    /// Returns the box whose level contains the line.
    [[nodiscard]] std::size_t parent_of(const SceneLine& line) const {
        const SceneBox& from = scene_.boxes[line.from];
        if (from.port_of == no_box) return from.parent;
        const SceneBox& owner = scene_.boxes[from.port_of];
        return owner.frame ? from.port_of : owner.parent;
    }

    /// Returns true if lines may join at a circle or port.
    [[nodiscard]] bool may_meet(std::size_t a, std::size_t b) const {
        for (const std::size_t x : {scene_.lines[a].from, scene_.lines[a].to})
            for (const std::size_t y : {scene_.lines[b].from, scene_.lines[b].to})
                if (x == y && (scene_.boxes[x].round || scene_.boxes[x].port_of != no_box)) return true;
        return false;
    }

    void lines_apart() {
        constexpr double near = 3;
        for (std::size_t i = 0; i < segments_.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const Segment& a = segments_[i];
                const Segment& b = segments_[j];
                if (a.line == b.line || a.horizontal() != b.horizontal() || may_meet(a.line, b.line)) continue;
                const double away = a.horizontal() ? std::abs(a.low_y - b.low_y) : std::abs(a.low_x - b.low_x);
                const double common = a.horizontal() ? std::min(a.high_x, b.high_x) - std::max(a.low_x, b.low_x)
                                                     : std::min(a.high_y, b.high_y) - std::max(a.low_y, b.low_y);
                if (away < near && common > 0.5)
                    complain("{} and {} run on each other at {:.0f} {:.0f}", name(a), name(b), a.low_x, a.low_y);
            }
    }

    void lines_around_boxes() {
        for (const Segment& segment : segments_)
            for (std::size_t b = 0; b < scene_.boxes.size(); ++b) {
                const SceneLine& line = scene_.lines[segment.line];
                const bool own = line.from == b || line.to == b;
                if (contains(b, parent_of(line)) || (own && scene_.boxes[b].round)) continue;
                if (through(segment, scene_.boxes[b].place, 0.5))
                    complain("{} goes through {}", line.name, scene_.boxes[b].name);
            }
    }

    void ends_on_borders() {
        for (const SceneLine& line : scene_.lines) {
            if (line.points.size() < 2) {
                complain("{} is not drawn", line.name);
                continue;
            }
            end_on_border(line, line.from, line.points.front());
            end_on_border(line, line.to, line.points.back());
        }
    }

    void end_on_border(const SceneLine& line, std::size_t b, const Point& end) {
        const SceneBox& box = scene_.boxes[b];
        const Rectangle& it = box.place;
        double away = 0;
        if (box.round) {
            away = std::abs(std::hypot(end.x - it.centre().x, end.y - it.centre().y) - it.width / 2);
        } else {
            const double x = std::max({it.x - end.x, end.x - it.right(), 0.0});
            const double y = std::max({it.y - end.y, end.y - it.bottom(), 0.0});
            const double inside = std::min({end.x - it.x, it.right() - end.x, end.y - it.y, it.bottom() - end.y});
            away = inside > 0 ? inside : std::hypot(x, y);
        }
        if (away > 1) complain("an end of {} is {:.1f} px from the border of {}", line.name, away, box.name);
    }

    const Scene& scene_;
    std::vector<Segment> segments_;
    std::vector<std::string> faults_;
};

/// Returns -1 if `a` is completely on the lower side of `b`, 1 on the upper side, otherwise 0.
int order_of(double a_low, double a_high, double b_low, double b_high) {
    if (a_high <= b_low) return -1;
    return b_high <= a_low ? 1 : 0;
}

bool flipped(int before, int after) {
    return before != 0 && after != 0 && before != after;
}

}  // namespace

Scene scene_of(const layout::Level& level, const layout::Placement& placement) {
    Scene scene;
    std::vector<std::vector<std::size_t>> ports(level.boxes.size());
    for (std::size_t b = 0; b < level.boxes.size(); ++b)
        scene.boxes.push_back(
            {fmt::format("b{}", b), placement.boxes[b].place, no_box, no_box, level.boxes[b].round, false});
    for (std::size_t b = 0; b < level.boxes.size(); ++b)
        for (std::size_t p = 0; p < level.boxes[b].ports.size(); ++p) {
            const Point centre = placement.boxes[b].ports[p].centre;
            constexpr double half = layout::port_size / 2;
            ports[b].push_back(scene.boxes.size());
            scene.boxes.push_back({fmt::format("b{}.{}", b, p),
                                   {centre.x - half, centre.y - half, layout::port_size, layout::port_size},
                                   no_box,
                                   b,
                                   false});
        }
    for (std::size_t e = 0; e < level.edges.size(); ++e) {
        const layout::Edge& edge = level.edges[e];
        scene.lines.push_back({fmt::format("e{}", e), edge.from_port ? ports[edge.from][*edge.from_port] : edge.from,
                               edge.to_port ? ports[edge.to][*edge.to_port] : edge.to, placement.edges[e].points,
                               placement.edges[e].label});
    }
    return scene;
}

Scene scene_of(const Picture& picture) {
    Scene scene;
    for (const PictureBox& box : picture.boxes) {
        const std::string title = box.texts.empty() ? "" : box.texts.front().text;
        scene.boxes.push_back({fmt::format("{} ({})", title, scene.boxes.size()), box.place, box.parent, box.event_of,
                               is_round(box.look), box.look == Look::frame});
    }
    for (const PictureLine& line : picture.lines)
        scene.lines.push_back({fmt::format("line {} from {} to {}", scene.lines.size(), scene.boxes[line.from].name,
                                           scene.boxes[line.to].name),
                               line.from, line.to, line.points, line.label});
    return scene;
}

std::vector<std::string> faults_of(const Scene& scene) {
    return Critic(scene).judge();
}

std::size_t crossings_of(const Scene& scene) {
    const std::vector<Segment> segments = segments_of(scene);
    std::size_t count = 0;
    for (const Segment& a : segments)
        for (const Segment& b : segments)
            if (a.line != b.line && a.horizontal() && !b.horizontal() && a.low_x + 0.5 < b.low_x &&
                b.low_x < a.high_x - 0.5 && b.low_y + 0.5 < a.low_y && a.low_y < b.high_y - 0.5)
                ++count;
    return count;
}

Flips flips_between(const Scene& before, const Scene& after) {
    std::map<std::string, const SceneBox*> now;
    for (const SceneBox& box : after.boxes) now.emplace(box.name, &box);
    Flips result;
    for (std::size_t i = 0; i < before.boxes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const SceneBox& a = before.boxes[i];
            const SceneBox& b = before.boxes[j];
            const auto a_now = now.find(a.name);
            const auto b_now = now.find(b.name);
            if (a.parent != b.parent || a.port_of != no_box || b.port_of != no_box || a_now == now.end() ||
                b_now == now.end())
                continue;
            const Rectangle& x = a_now->second->place;
            const Rectangle& y = b_now->second->place;
            ++result.pairs;
            if (flipped(order_of(a.place.x, a.place.right(), b.place.x, b.place.right()),
                        order_of(x.x, x.right(), y.x, y.right())) ||
                flipped(order_of(a.place.y, a.place.bottom(), b.place.y, b.place.bottom()),
                        order_of(x.y, x.bottom(), y.y, y.bottom())))
                ++result.flipped;
        }
    return result;
}

}  // namespace robochart::diagrams
