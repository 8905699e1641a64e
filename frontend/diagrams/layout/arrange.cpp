// SPDX-License-Identifier: Apache-2.0
// Runs the steps of the layout in order. The connected components of a level are laid out separately and arranged in
// rows.
#include "frontend/diagrams/layout/arrange.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "frontend/diagrams/layout/graph.hpp"
#include "frontend/diagrams/layout/routes.hpp"

namespace robochart::diagrams::layout {
namespace {

/// A connected component of a level, with the indices of its boxes and edges in the level.
struct Part {
    Level level;
    std::vector<std::size_t> boxes, edges;
};

/// Disjoint sets of boxes. The first box represents its set.
class Partition {
public:
    explicit Partition(std::size_t boxes) : parent_(boxes) { std::iota(parent_.begin(), parent_.end(), 0); }

    std::size_t set_of(std::size_t box) {
        while (parent_[box] != box) box = parent_[box] = parent_[parent_[box]];
        return box;
    }
    void join_sets(std::size_t a, std::size_t b) {
        const auto [first, second] = std::minmax({set_of(a), set_of(b)});
        parent_[second] = first;
    }

private:
    std::vector<std::size_t> parent_;
};

/// Divides the boxes into parts. Two boxes are in the same part if an edge joins them, if both are pinned to an end of
/// the level, or if they were in the same part before an edit.
Partition partition_of(const Level& level) {
    Partition partition(level.boxes.size());
    for (const Edge& edge : level.edges) partition.join_sets(edge.from, edge.to);
    std::size_t pinned = nothing;
    std::map<std::size_t, std::size_t> first_of;
    for (std::size_t b = 0; b < level.boxes.size(); ++b) {
        const Box& box = level.boxes[b];
        if (box.pin != Pin::none) {
            if (pinned == nothing) pinned = b;
            partition.join_sets(b, pinned);
        }
        if (box.previous) partition.join_sets(b, first_of.emplace(box.previous->part, b).first->second);
    }
    return partition;
}

/// Keeps only the previous positions in the first part before an edit, because positions in different parts cannot be
/// compared.
void forget_other_parts(Level& level) {
    std::optional<std::size_t> part;
    for (Box& box : level.boxes) {
        if (!box.previous) continue;
        if (!part) part = box.previous->part;
        if (box.previous->part != *part) box.previous.reset();
    }
    for (Edge& edge : level.edges)
        if (!level.boxes[edge.from].previous || !level.boxes[edge.to].previous) edge.previous.clear();
}

/// Returns the parts of a level in the order of their first boxes.
std::vector<Part> parts_of(const Level& level) {
    Partition partition = partition_of(level);
    std::vector<Part> parts;
    std::vector<std::size_t> part_of(level.boxes.size(), nothing);
    std::vector<std::size_t> place(level.boxes.size());
    for (std::size_t b = 0; b < level.boxes.size(); ++b) {
        std::size_t& part = part_of[partition.set_of(b)];
        if (part == nothing) {
            part = parts.size();
            parts.emplace_back();
        }
        place[b] = parts[part].boxes.size();
        parts[part].boxes.push_back(b);
        parts[part].level.boxes.push_back(level.boxes[b]);
    }
    for (std::size_t e = 0; e < level.edges.size(); ++e) {
        Part& part = parts[part_of[partition.set_of(level.edges[e].from)]];
        Edge edge = level.edges[e];
        edge.from = place[edge.from];
        edge.to = place[edge.to];
        part.edges.push_back(e);
        part.level.edges.push_back(edge);
    }
    for (Part& part : parts) forget_other_parts(part.level);
    return parts;
}

/// A graph whose layers have been ordered.
struct Layered {
    Graph graph;
    Ordered ordered;
};

Layered make_layers(const Level& level, bool turned, Cycles cycles, diagnostics::Budget* budget) {
    Layered result;
    result.graph.level = &level;
    result.graph.turned = turned;
    result.graph.budget = budget;
    break_cycles(result.graph, cycles);
    assign_layers(result.graph);
    make_nodes(result.graph);
    result.ordered = order_layers(result.graph);
    return result;
}

/// Larger graphs are laid out only once.
constexpr std::size_t most_nodes_twice = 250;

/// True if the boxes that existed before an edit are in the same layers.
bool same_layers(const Level& level, const Graph& one, const Graph& other) {
    for (std::size_t b = 0; b < level.boxes.size(); ++b)
        if (level.boxes[b].previous && one.layer_of_box[b] != other.layer_of_box[b]) return false;
    return true;
}

/// Tries a second choice of reversed edges, and uses it if it is better. Without an edit, the second choice reverses
/// few edges, and is tried if the first result has crossings. After an edit, it reverses edges of added boxes, and is
/// tried if the first result changes the previous order.
Layered best_layered(const Level& level, bool turned, diagnostics::Budget* budget) {
    Layered found = make_layers(level, turned, Cycles::text, budget);
    const bool edited = std::ranges::any_of(level.boxes, [](const Box& box) { return box.previous.has_value(); });
    const bool good = edited ? found.ordered.as_before : found.ordered.crossings == 0;
    if (good || found.graph.nodes.size() > most_nodes_twice) return found;
    Layered other = make_layers(level, turned, edited ? Cycles::kept : Cycles::few, budget);
    const bool better = edited ? other.ordered.as_before && other.ordered.crossings <= found.ordered.crossings &&
                                     same_layers(level, found.graph, other.graph)
                               : other.ordered.crossings < found.ordered.crossings;
    return better ? std::move(other) : std::move(found);
}

Placement arrange_part(const Level& level, bool turned, diagnostics::Budget* budget) {
    Layered found = best_layered(level, turned, budget);
    place_nodes(found.graph);
    place_tracks(found.graph);
    return placement_of(found.graph);
}

/// The position of a part.
struct Spot {
    std::size_t part = 0, row = 0;
    double x = 0, y = 0;
};

void add_part(Placement& whole, const Part& part, const Spot& spot, Placement placed) {
    const auto [number, row, x, y] = spot;
    for (std::size_t i = 0; i < part.boxes.size(); ++i) {
        PlacedBox& box = placed.boxes[i];
        box.rank.part = number;
        box.rank.row = row;
        box.place.x += x;
        box.place.y += y;
        for (PlacedPort& port : box.ports) port.centre = {port.centre.x + x, port.centre.y + y};
        whole.boxes[part.boxes[i]] = std::move(box);
    }
    for (std::size_t i = 0; i < part.edges.size(); ++i) {
        PlacedEdge& edge = placed.edges[i];
        for (Point& point : edge.points) point = {point.x + x, point.y + y};
        edge.label.x += x;
        edge.label.y += y;
        whole.edges[part.edges[i]] = std::move(edge);
    }
    whole.size.width = std::max(whole.size.width, x + placed.size.width);
    whole.size.height = std::max(whole.size.height, y + placed.size.height);
}

/// Returns the width of the rows. It is the width of the widest part, or the width at which the layout is about 1.5
/// times as wide as high, whichever is larger.
double row_width(const std::vector<Placement>& placed) {
    double widest = 0;
    double area = 0;
    for (const Placement& part : placed) {
        widest = std::max(widest, part.size.width);
        area += (part.size.width + distance::boxes) * (part.size.height + distance::boxes);
    }
    return std::max(widest, std::sqrt(area * 1.5));
}

/// Arranges parts in rows, between the pinned boxes at both ends of the level.
class Rows {
public:
    Rows(Placement& whole, double width) : whole_(whole), right_(width) {}

    /// Adds a part with pinned boxes in a separate row. Later parts are placed between its pinned boxes.
    void add_pinned(const Part& part, std::size_t number, Placement placed) {
        double left = 0;
        double right = std::max(right_, placed.size.width);
        for (std::size_t i = 0; i < part.boxes.size(); ++i) {
            const Rectangle& place = placed.boxes[i].place;
            if (!part.level.boxes[i].on_border) continue;
            if (part.level.boxes[i].pin == Pin::first) left = std::max(left, place.right() + distance::boxes);
            if (part.level.boxes[i].pin == Pin::last) right = std::min(right, place.x - distance::boxes);
        }
        const double height = placed.size.height;
        add_part(whole_, part, {number, 0, 0, 0}, std::move(placed));
        x_ = left_ = left;
        right_ = right;
        y_ = height + distance::boxes;
    }

    void add(const Part& part, std::size_t number, Placement placed) {
        const Size size = placed.size;
        if (x_ > left_ && begins_row(part, size)) {
            ++row_;
            y_ += std::exchange(height_, 0) + distance::boxes;
            x_ = left_;
        }
        add_part(whole_, part, {number, row_, x_, y_}, std::move(placed));
        x_ += size.width + distance::boxes;
        height_ = std::max(height_, size.height);
    }

private:
    /// True if the part begins a new row. After an edit, the rows are the same as before. Otherwise a new row begins
    /// when the current one is full.
    [[nodiscard]] bool begins_row(const Part& part, const Size& size) const {
        for (const Box& box : part.level.boxes)
            if (box.previous) return box.previous->row != row_;
        return x_ + size.width > right_;
    }

    Placement& whole_;
    std::size_t row_ = 0;
    double left_ = 0, right_ = 0, x_ = 0, y_ = 0;
    double height_ = 0;  ///< the height of the current row
};

Placement arrange_in(const Level& level, const std::vector<Part>& parts, bool turned, diagnostics::Budget* budget) {
    std::vector<Placement> placed;
    for (const Part& part : parts) placed.push_back(arrange_part(part.level, turned, budget));
    Placement whole;
    whole.direction = turned ? Direction::right : Direction::down;
    whole.boxes.resize(level.boxes.size());
    whole.edges.resize(level.edges.size());
    Rows rows(whole, row_width(placed));
    const auto pinned = [&](const Part& part) {
        return std::ranges::any_of(part.level.boxes, [](const Box& box) { return box.on_border; });
    };
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (pinned(parts[i])) rows.add_pinned(parts[i], i, std::move(placed[i]));
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (!pinned(parts[i])) rows.add(parts[i], i, std::move(placed[i]));
    return whole;
}

/// Returns the size of a page with aspect ratio 3:2 that contains the layout.
double page_extent(const Size& size) {
    return std::max(size.width / 1.5, size.height);
}

/// True if the level has loops. A loop is drawn at the right side of its box, where the edges of a layout to the right
/// begin.
bool has_loops(const Level& level) {
    return std::ranges::any_of(level.edges, [](const Edge& edge) { return edge.from == edge.to && !edge.from_port; });
}

}  // namespace

Placement arrange_level(const Level& level, diagnostics::Budget* budget) {
    const std::vector<Part> parts = parts_of(level);
    const bool ports = std::ranges::any_of(level.boxes, [](const Box& box) { return !box.ports.empty(); });
    if (ports) return arrange_in(level, parts, true, budget);
    if (level.direction == Direction::down || has_loops(level)) return arrange_in(level, parts, false, budget);
    if (level.direction == Direction::right) return arrange_in(level, parts, true, budget);
    Placement down = arrange_in(level, parts, false, budget);
    Placement right = arrange_in(level, parts, true, budget);
    // Chooses the layout to the right only if it is clearly better. After an edit, the previous direction is used
    // unless it is much worse.
    double bound = 0.85;
    if (level.previous) bound = level.previous == Direction::right ? 1.3 : 0.7;
    return page_extent(right.size) < bound * page_extent(down.size) ? right : down;
}

}  // namespace robochart::diagrams::layout
