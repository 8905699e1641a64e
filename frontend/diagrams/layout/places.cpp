// SPDX-License-Identifier: Apache-2.0
// Computes the x of every node. Sweeps over the layers solve each layer exactly for the current positions of its
// neighbours. Then edges are straightened where there is space. Finally, the edge ends on the sides of boxes are
// placed.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "frontend/diagrams/layout/graph.hpp"
#include "frontend/diagrams/layout/isotonic.hpp"

namespace robochart::diagrams::layout {
namespace {

constexpr double far = 1e9;

/// Returns the nearest whole number. Halves are rounded up on both sides of zero, so that a shift by a whole number
/// does not change distances.
double round_half_up(double x) {
    return std::floor(x + 0.5);
}

/// An interval; empty if `low` is above `high`.
struct Interval {
    double low = -far, high = far;
    [[nodiscard]] bool empty() const { return low > high; }
    [[nodiscard]] double nearest(double x) const { return std::clamp(x, low, high); }
};
Interval intersection_of(const Interval& a, const Interval& b) {
    return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

double distance_between(const Graph& graph, const Node& left, const Node& right) {
    const auto on_border = [&](const Node& node) { return node.is_box() && graph.level->boxes[node.box].on_border; };
    if (on_border(left) && on_border(right)) return distance::ports - port_size;
    if (left.is_box() && right.is_box()) return distance::boxes;
    if (!left.is_box() && !right.is_box()) return distance::lines;
    return graph.has_ports ? distance::lines : distance::box_line;
}

/// Returns the minimum distance between the x of two adjacent nodes of a layer.
double minimum_separation(const Graph& graph, const Node& left, const Node& right) {
    return left.after + right.before + distance_between(graph, left, right);
}

/// Returns the interval of the edge ends on one side of a box.
Interval side_of(const Graph& graph, const Node& node, std::size_t ends) {
    const Box& box = graph.level->boxes[node.box];
    if (box.round) {
        const double reach = ends > 1 ? node.before * 0.6 : 0;
        return {node.x - reach, node.x + reach};
    }
    const double left = node.x - node.before;
    const double right = node.x + node.after - node.loops;
    if (box.on_border) return {node.x, node.x};
    if (!box.ports.empty()) return {left + box.port_start + distance::port_margin, right - distance::port_margin};
    return {left + distance::slot_margin, right - distance::slot_margin};
}

class Placing {
public:
    explicit Placing(Graph& graph) : graph_(graph), nodes_(graph.nodes) {}

    void run() {
        pack_layers();
        const bool large = nodes_.size() > 3'000;
        for (int round = 0; round < (large ? 2 : 6); ++round) sweep_layers(round % 2 == 0, true);
        for (int round = 0; round < (large ? 2 : 24); ++round) sweep_layers(round % 2 == 0, false);
        if (graph_.has_ports && !large) meet_ports();
        for (int round = 0; round < 3; ++round) straighten_all();
        round_all();
        place_ends();
        for (int round = 0; round < 2; ++round) {
            follow_ends();
            round_all();
            place_ends();
        }
        if (!large)
            for (std::size_t e = 0; e < graph_.chains.size(); ++e) {
                take_jog_away(e);
                if (graph_.chains[e].size() < 2) continue;
                meet_line(graph_.chains[e].front(), true);
                meet_line(graph_.chains[e].back(), false);
            }
        move_to_origin();
    }

private:
    /// Moves boxes so that connected ports are directly opposite.
    void meet_ports() {
        for (int round = 0; round < 12; ++round) {
            place_ends();
            for (Link& link : graph_.links) {
                link.upper_offset = link.upper_x - nodes_[link.upper].x;
                link.lower_offset = link.lower_x - nodes_[link.lower].x;
            }
            sweep_layers(round % 2 == 0, false);
        }
        round_all();
        for (int round = 0; round < 2; ++round)
            for (std::size_t layer = 1; layer < graph_.layers.size(); ++layer)
                for (const std::size_t n : graph_.layers[layer])
                    if (nodes_[n].is_box()) make_straight(n);
    }

    /// Moves a box slightly so that as many edges from above as possible are straight.
    void make_straight(std::size_t n) {
        constexpr double little = 24;
        place_ends();
        std::map<double, std::size_t> shifts;
        for (const auto& chain : graph_.chains) {
            if (chain.empty() || graph_.links[chain.back()].lower != n) continue;
            const double shift = graph_.links[chain.front()].upper_x - graph_.links[chain.back()].lower_x;
            if (std::abs(shift) <= little) ++shifts[shift];
        }
        const auto best = std::ranges::max_element(shifts, [](const auto& a, const auto& b) {
            return std::pair(a.second, -std::abs(a.first)) < std::pair(b.second, -std::abs(b.first));
        });
        if (best == shifts.end()) return;
        nodes_[n].x = free_around(n).nearest(nodes_[n].x + best->first);
    }

    void pack_layers() {
        for (const auto& layer : graph_.layers) {
            double x = 0;
            for (std::size_t i = 0; i < layer.size(); ++i) {
                if (i > 0) x += minimum_separation(graph_, nodes_[layer[i - 1]], nodes_[layer[i]]);
                nodes_[layer[i]].x = x;
            }
            for (const std::size_t n : layer) nodes_[n].x -= x / 2;
        }
    }

    void sweep_layers(bool downwards, bool one_sided) {
        const std::size_t count = graph_.layers.size();
        for (std::size_t i = 0; i < count; ++i) {
            graph_.poll();
            place_layer(graph_.layers[downwards ? i : count - 1 - i], !one_sided || downwards,
                        !one_sided || !downwards);
        }
    }

    void place_layer(const std::vector<std::size_t>& layer, bool above, bool below) {
        std::vector<Wish> wishes;
        for (std::size_t i = 0; i < layer.size(); ++i) {
            const Node& node = nodes_[layer[i]];
            Wish wish = this->wish_for(node, above, below);
            if (i > 0) wish.gap = minimum_separation(graph_, nodes_[layer[i - 1]], node);
            wishes.push_back(wish);
        }
        const std::vector<double> places = nearest_places(wishes);
        for (std::size_t i = 0; i < layer.size(); ++i) nodes_[layer[i]].x = places[i];
    }

    /// Links of boxes weigh less than links between two points of a line.
    static double weight_of_link(const Node& node, const Node& other) {
        if (node.is_box() && other.is_box()) return 1;
        return node.is_box() || other.is_box() ? 3 : 40;
    }

    /// Returns the mean position of the neighbours. A node between two lines follows these lines.
    [[nodiscard]] Wish wish_for(const Node& node, bool above, bool below) const {
        double sum = 0;
        double weight = 0;
        const auto add = [&](const std::vector<std::size_t>& links, bool up) {
            for (const std::size_t l : links) {
                const Link& link = graph_.links[l];
                if (link.turn != Link::Turn::none) continue;
                const Node& other = nodes_[up ? link.upper : link.lower];
                const double link_weight = weight_of_link(node, other);
                const double here = up ? link.lower_offset : link.upper_offset;
                const double there = up ? link.upper_offset : link.lower_offset;
                sum += link_weight * (other.x + there - here);
                weight += link_weight;
            }
        };
        if (above) add(node.up, true);
        if (below) add(node.down, false);
        return weight > 0 ? Wish{sum / weight, weight, 0} : Wish{node.x, 0.05, 0};
    }

    /// Returns the interval in which a node may move while its neighbours stay.
    [[nodiscard]] Interval free_around(std::size_t n) const {
        const Node& node = nodes_[n];
        const auto& layer = graph_.layers[node.layer];
        Interval result;
        if (node.position > 0) {
            const Node& left = nodes_[layer[node.position - 1]];
            result.low = left.x + minimum_separation(graph_, left, node);
        }
        if (node.position + 1 < layer.size()) {
            const Node& right = nodes_[layer[node.position + 1]];
            result.high = right.x - minimum_separation(graph_, node, right);
        }
        return result;
    }

    /// Returns the nodes that an edge passes, without the boxes at its ends.
    [[nodiscard]] std::vector<std::size_t> nodes_passed_by(std::size_t edge) const {
        std::vector<std::size_t> result;
        for (const std::size_t l : graph_.chains[edge])
            if (!nodes_[graph_.links[l].lower].is_box()) result.push_back(graph_.links[l].lower);
        return result;
    }

    void straighten_all() {
        for (std::size_t e = 0; e < graph_.chains.size(); ++e) {
            graph_.poll();
            if (graph_.chains[e].size() < 2) continue;
            const Link& first = graph_.links[graph_.chains[e].front()];
            const Link& last = graph_.links[graph_.chains[e].back()];
            straighten_chain(nodes_passed_by(e), side_of(graph_, nodes_[first.upper], nodes_[first.upper].down.size()),
                             side_of(graph_, nodes_[last.lower], nodes_[last.lower].up.size()));
        }
    }

    /// Moves the nodes to one x that is above both ends if possible. If there is no common x, uses as few as possible.
    void straighten_chain(const std::vector<std::size_t>& chain, const Interval& upper, const Interval& lower) {
        for (std::size_t begin = 0; begin < chain.size();) {
            Interval free = free_around(chain[begin]);
            double sum = nodes_[chain[begin]].x;
            std::size_t end = begin + 1;
            for (; end < chain.size(); ++end) {
                const Interval narrower = intersection_of(free, free_around(chain[end]));
                if (narrower.empty()) break;
                free = narrower;
                sum += nodes_[chain[end]].x;
            }
            if (free.empty()) free = {nodes_[chain[begin]].x, nodes_[chain[begin]].x};  // due to a rounding error
            if (begin == 0 && !intersection_of(free, upper).empty()) free = intersection_of(free, upper);
            if (end == chain.size() && !intersection_of(free, lower).empty()) free = intersection_of(free, lower);
            const double x = free.nearest(sum / static_cast<double>(end - begin));
            for (; begin < end; ++begin) nodes_[chain[begin]].x = x;
        }
    }

    /// Rounds positions to whole pixels, so that straight lines are exactly straight.
    void round_all() {
        for (Node& node : nodes_) node.x = round_half_up(node.x);
    }

    /// Edge ends on one side of a box that share a position.
    struct Slot {
        std::vector<std::size_t> links;
        std::size_t port = nothing;
        double order = 0;
        double target = 0;
    };

    void place_ends() {
        for (Link& link : graph_.links) {
            link.upper_x = nodes_[link.upper].x;
            link.lower_x = nodes_[link.lower].x;
        }
        for (std::size_t b = 0; b < graph_.level->boxes.size(); ++b) {
            graph_.poll();
            place_ends(b, false);
            place_ends(b, true);
        }
    }

    void place_ends(std::size_t b, bool down) {
        const Node& node = nodes_[b];
        std::vector<Slot> slots = graph_.ports[b].empty() ? own_slots(b, down) : port_slots(b, down);
        if (slots.empty()) return;
        for (Slot& slot : slots) wish_of(b, slot, down);
        std::ranges::stable_sort(slots, [](const Slot& x, const Slot& y) { return x.order < y.order; });
        std::vector<Wish> wishes;
        const double gap = graph_.ports[b].empty() ? distance::slots : distance::ports;
        for (const Slot& slot : slots) wishes.push_back({slot.target, 1, gap});
        const Interval side = side_of(graph_, node, slots.size());
        const std::vector<double> places = nearest_places(wishes, side.low, std::max(side.low, side.high));
        for (std::size_t i = 0; i < slots.size(); ++i) {
            const double x = node.x + round_half_up(places[i] - node.x);
            if (slots[i].port != nothing) graph_.ports[b][slots[i].port].x = x;
            for (const std::size_t l : slots[i].links) end_of(l, b, slots[i].port, down) = x;
        }
    }

    /// Returns the end of a link at a box. For a turn from a box to itself, this is the end at the port.
    double& end_of(std::size_t l, std::size_t b, std::size_t port, bool down) {
        Link& link = graph_.links[l];
        if (link.upper == link.lower) return link.upper_port == port ? link.upper_x : link.lower_x;
        const bool upper = link.turn == Link::Turn::none ? down : link.upper == b;
        return upper ? link.upper_x : link.lower_x;
    }

    [[nodiscard]] std::vector<Slot> own_slots(std::size_t b, bool down) const {
        std::vector<Slot> slots;
        for (const std::size_t l : down ? nodes_[b].down : nodes_[b].up) slots.push_back({{l}, nothing, 0, 0});
        return slots;
    }

    [[nodiscard]] std::vector<Slot> port_slots(std::size_t b, bool down) const {
        std::vector<Slot> slots;
        for (std::size_t p = 0; p < graph_.ports[b].size(); ++p) {
            if (graph_.ports[b][p].down != down) continue;
            Slot slot{{}, p, 0, 0};
            for (const std::size_t l : down ? nodes_[b].down : nodes_[b].up) {
                const Link& link = graph_.links[l];
                if ((link.upper == b && link.upper_port == p) || (link.lower == b && link.lower_port == p))
                    slot.links.push_back(l);
            }
            slots.push_back(slot);
        }
        return slots;
    }

    /// Computes the wanted position and the order of an end at a side of a box. The order is that of the nodes to which
    /// the links lead. Turns to the left come first, and turns to the right come last.
    void wish_of(std::size_t b, Slot& slot, bool down) const {
        const Node& node = nodes_[b];
        slot.target = slot.links.empty() ? node.x : 0;
        slot.order = slot.links.empty() ? far : 0;
        for (const std::size_t l : slot.links) {
            const Link& link = graph_.links[l];
            const bool turn = link.turn != Link::Turn::none;
            const bool to_lower = turn ? link.upper == b : down;
            const std::size_t n = to_lower ? link.lower : link.upper;
            const auto count = static_cast<double>(slot.links.size());
            const auto position = static_cast<double>(nodes_[n].position);
            const double beside = nodes_[n].position < node.position ? -1e6 : 1e6;
            slot.target += nodes_[n].x / count;
            slot.order += (turn ? position + beside : position) / count;
        }
    }

    /// Moves lines that are almost above one of their ends to this end, if there is space.
    void follow_ends() {
        for (std::size_t e = 0; e < graph_.chains.size(); ++e) {
            if (graph_.chains[e].size() < 2) continue;
            const double upper = graph_.links[graph_.chains[e].front()].upper_x;
            const double lower = graph_.links[graph_.chains[e].back()].lower_x;
            straighten_chain(nodes_passed_by(e), {upper, upper}, {lower, lower});
        }
    }

    /// Straightens an edge whose ends are almost opposite, if there is space.
    void take_jog_away(std::size_t e) {
        constexpr double little = 18;
        const auto& chain = graph_.chains[e];
        if (chain.size() < 2) return;
        Link& first = graph_.links[chain.front()];
        Link& last = graph_.links[chain.back()];
        if (std::abs(first.upper_x - last.lower_x) > little) return;
        for (const double x : {first.upper_x, last.lower_x}) {
            const bool free = is_free(chain.front(), true, x) && is_free(chain.back(), false, x);
            const std::vector<std::size_t> nodes = nodes_passed_by(e);
            const auto can_move = [&](std::size_t n) {
                const Interval around = free_around(n);
                return around.low <= x && x <= around.high;
            };
            if (!free || !std::ranges::all_of(nodes, can_move)) continue;
            for (const std::size_t n : nodes) nodes_[n].x = x;
            for (const std::size_t l : chain) graph_.links[l].upper_x = graph_.links[l].lower_x = x;
            move_port(first.upper, first.upper_port, x);
            move_port(last.lower, last.lower_port, x);
            return;
        }
    }

    /// Moves an end that is almost opposite the continuation of its line to this position.
    void meet_line(std::size_t l, bool upper) {
        constexpr double little = 8;
        Link& link = graph_.links[l];
        const double x = nodes_[upper ? link.lower : link.upper].x;
        double& end = upper ? link.upper_x : link.lower_x;
        if (link.turn != Link::Turn::none || end == x || std::abs(end - x) > little || !is_free(l, upper, x)) return;
        end = x;
        move_port(upper ? link.upper : link.lower, upper ? link.upper_port : link.lower_port, x);
    }

    void move_port(std::size_t node, std::size_t port, double x) {
        if (port != nothing) graph_.ports[nodes_[node].box][port].x = x;
        if (graph_.level->boxes[nodes_[node].box].on_border) nodes_[node].x = x;
    }

    /// True if the end of a link may be at this position of a box, because no other edge ends near it.
    [[nodiscard]] bool is_free(std::size_t l, bool upper, double x) const {
        const Link& link = graph_.links[l];
        if (link.turn != Link::Turn::none) return false;
        const std::size_t b = upper ? link.upper : link.lower;
        const std::size_t port = upper ? link.upper_port : link.lower_port;
        if ((upper ? link.upper_x : link.lower_x) == x) return true;
        const std::vector<std::size_t>& ends = upper ? nodes_[b].down : nodes_[b].up;
        if (graph_.level->boxes[nodes_[b].box].on_border) {
            const Interval around = free_around(b);  // the box itself moves
            return ends.size() == 1 && around.low <= x && x <= around.high;
        }
        const Interval side = side_of(graph_, nodes_[b], ends.size());
        if (x < side.low || x > side.high) return false;
        if (port != nothing) return is_free_port(b, port, ends, x);
        return std::ranges::all_of(ends, [&](std::size_t other) {
            const Link& it = graph_.links[other];
            return other == l || std::abs((it.upper == b ? it.upper_x : it.lower_x) - x) >= distance::slots;
        });
    }

    [[nodiscard]] bool is_free_port(std::size_t b, std::size_t port, const std::vector<std::size_t>& ends,
                                    double x) const {
        std::size_t users = 0;
        for (const std::size_t l : ends) {
            const Link& link = graph_.links[l];
            if ((link.upper == b && link.upper_port == port) || (link.lower == b && link.lower_port == port)) ++users;
        }
        if (users != 1) return false;
        const auto& ports = graph_.ports[b];
        for (std::size_t p = 0; p < ports.size(); ++p)
            if (p != port && ports[p].down == ports[port].down && std::abs(ports[p].x - x) < distance::ports)
                return false;
        return true;
    }

    void move_to_origin() {
        double least = far;
        for (const Node& node : nodes_) least = std::min(least, node.x - node.before);
        for (const Link& link : graph_.links) least = std::min({least, link.upper_x, link.lower_x});
        least = std::floor(least);
        for (Node& node : nodes_) node.x -= least;
        for (Link& link : graph_.links) {
            link.upper_x -= least;
            link.lower_x -= least;
        }
        for (auto& ports : graph_.ports)
            for (GraphPort& port : ports) port.x -= least;
    }

    Graph& graph_;
    std::vector<Node>& nodes_;
};

}  // namespace

void place_nodes(Graph& graph) {
    Placing(graph).run();
}

}  // namespace robochart::diagrams::layout
