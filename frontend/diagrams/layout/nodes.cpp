// SPDX-License-Identifier: Apache-2.0
// Makes the nodes and links of all edges. An edge passes every layer between its ends. Its label is in the odd layer
// nearest to the middle. An edge that ends at a port on the side away from its other end turns next to the box.
#include <algorithm>
#include <utility>

#include "frontend/diagrams/layout/arrange.hpp"
#include "frontend/diagrams/layout/graph.hpp"

namespace robochart::diagrams::layout {
namespace {

constexpr std::size_t most_nodes = 100'000;

/// An end of an edge.
struct End {
    std::size_t box = nothing;
    std::size_t port = nothing;
};

class NodeMaker {
public:
    explicit NodeMaker(Graph& graph) : graph_(graph), level_(*graph.level) {}

    void make_all() {
        make_boxes();
        decide_sides();
        graph_.chains.resize(level_.edges.size());
        for (std::size_t e = 0; e < level_.edges.size(); ++e) make_edge(e);
        size_boxes();
        for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
            auto& layer = graph_.layers[graph_.nodes[n].layer];
            graph_.nodes[n].position = layer.size();
            layer.push_back(n);
        }
    }

private:
    void make_boxes() {
        std::size_t last = 0;
        for (std::size_t b = 0; b < level_.boxes.size(); ++b) {
            Node node;
            node.kind = Node::Kind::box;
            node.box = b;
            node.layer = 2 * graph_.layer_of_box[b];
            last = std::max(last, node.layer);
            graph_.nodes.push_back(std::move(node));
        }
        graph_.layers.resize(last + 1);
    }

    /// Chooses the side of each port: the side to which more of its edges lead or, for a port without edges, the side
    /// with fewer ports.
    void decide_sides() {
        std::vector<std::vector<int>> towards(level_.boxes.size());
        for (std::size_t b = 0; b < level_.boxes.size(); ++b) {
            towards[b].resize(level_.boxes[b].ports.size());
            graph_.has_ports = graph_.has_ports || !towards[b].empty();
        }
        for (const Edge& edge : level_.edges) {
            if (!edge.from_port || !edge.to_port) continue;
            const auto [from, to] = std::pair(graph_.layer_of_box[edge.from], graph_.layer_of_box[edge.to]);
            if (from == to) continue;
            towards[edge.from][*edge.from_port] += from < to ? 1 : -1;
            towards[edge.to][*edge.to_port] += from < to ? -1 : 1;
        }
        graph_.ports.resize(level_.boxes.size());
        for (std::size_t b = 0; b < level_.boxes.size(); ++b) decide_sides_of(b, towards[b]);
    }

    void decide_sides_of(std::size_t box, const std::vector<int>& towards) {
        int more_down = 0;
        graph_.ports[box].resize(towards.size());
        for (std::size_t p = 0; p < towards.size(); ++p) {
            bool& down = graph_.ports[box][p].down;
            down = towards[p] != 0 ? towards[p] > 0 : more_down <= 0;
            if (level_.boxes[box].pin != Pin::none) down = level_.boxes[box].pin == Pin::first;
            more_down += down ? 1 : -1;
        }
    }

    [[nodiscard]] bool leaves_down(const End& end, bool without_port) const {
        return end.port == nothing ? without_port : graph_.ports[end.box][end.port].down;
    }

    void make_edge(std::size_t e) {
        const Edge& edge = level_.edges[e];
        graph_.poll();
        if (edge.from == edge.to && !edge.from_port) return;  // a loop next to the box
        End upper{edge.from, edge.from_port.value_or(nothing)};
        End lower{edge.to, edge.to_port.value_or(nothing)};
        const std::size_t from = graph_.layer_of_box[edge.from];
        const std::size_t to = graph_.layer_of_box[edge.to];
        graph_.reversed[e] = from > to;
        if (graph_.reversed[e]) std::swap(upper, lower);
        if (from == to)
            make_turn(e, upper, lower);
        else
            make_chain(e, upper, lower);
    }

    /// Makes the turn of an edge between boxes of one layer.
    void make_turn(std::size_t e, const End& upper, const End& lower) {
        const bool upper_down = leaves_down(upper, true);
        const bool lower_down = leaves_down(lower, true);
        if (upper_down == lower_down) {
            add_link(e, upper.box, lower.box, upper_down ? Link::Turn::under : Link::Turn::over, upper.port,
                     lower.port);
            return;
        }
        const std::size_t middle = add_node(e, graph_.nodes[upper.box].layer);
        add_link(e, upper.box, middle, upper_down ? Link::Turn::under : Link::Turn::over, upper.port, nothing);
        add_link(e, middle, lower.box, lower_down ? Link::Turn::under : Link::Turn::over, nothing, lower.port);
    }

    void make_chain(std::size_t e, const End& upper, const End& lower) {
        const std::size_t first = graph_.nodes[upper.box].layer;
        const std::size_t last = graph_.nodes[lower.box].layer;
        std::size_t at = upper.box;
        std::size_t port = upper.port;
        if (!leaves_down(upper, true)) {
            const std::size_t turn = add_node(e, first);
            add_link(e, at, turn, Link::Turn::over, port, nothing);
            at = turn;
            port = nothing;
        }
        const std::size_t half = first / 2 + last / 2;
        const std::size_t label_layer = half % 2 == 1 ? half : half - 1;
        for (std::size_t layer = first + 1; layer < last; ++layer) {
            const std::size_t next = add_node(e, layer, layer == label_layer);
            add_link(e, at, next, Link::Turn::none, std::exchange(port, nothing), nothing);
            at = next;
        }
        if (leaves_down(lower, false)) {
            const std::size_t turn = add_node(e, last);
            add_link(e, at, turn, Link::Turn::none, port, nothing);
            add_link(e, turn, lower.box, Link::Turn::under, nothing, lower.port);
        } else {
            add_link(e, at, lower.box, Link::Turn::none, port, lower.port);
        }
    }

    std::size_t add_node(std::size_t e, std::size_t layer, bool with_label = false) {
        if (graph_.nodes.size() >= most_nodes) throw TooLarge("too many nodes and transitions for a diagram");
        Node node;
        node.edge = e;
        node.layer = layer;
        const Size& label = level_.edges[e].label;
        if (with_label && !label.empty()) {
            node.kind = Node::Kind::label;
            node.after = graph_.label_gap() + (graph_.turned ? label.height : label.width);
            node.above = node.below = (graph_.turned ? label.width : label.height) / 2;
        }
        graph_.nodes.push_back(std::move(node));
        return graph_.nodes.size() - 1;
    }

    void add_link(std::size_t e, std::size_t upper, std::size_t lower, Link::Turn turn, std::size_t upper_port,
                  std::size_t lower_port) {
        const std::size_t number = graph_.links.size();
        Link link;
        link.upper = upper;
        link.lower = lower;
        link.turn = turn;
        link.edge = e;
        link.upper_port = upper_port;
        link.lower_port = lower_port;
        graph_.links.push_back(std::move(link));
        graph_.chains[e].push_back(number);
        (turn == Link::Turn::over ? graph_.nodes[upper].up : graph_.nodes[upper].down).push_back(number);
        (turn == Link::Turn::under ? graph_.nodes[lower].down : graph_.nodes[lower].up).push_back(number);
    }

    void size_boxes() {
        std::vector<std::vector<std::size_t>> loops(level_.boxes.size());
        for (std::size_t e = 0; e < level_.edges.size(); ++e)
            if (level_.edges[e].from == level_.edges[e].to && !level_.edges[e].from_port)
                loops[level_.edges[e].from].push_back(e);
        for (std::size_t b = 0; b < level_.boxes.size(); ++b) {
            if (level_.boxes[b].ports.empty())
                size_box(b, loops[b]);
            else
                size_box_with_ports(b);
        }
    }

    void size_box(std::size_t b, const std::vector<std::size_t>& loops) {
        const Box& box = level_.boxes[b];
        Node& node = graph_.nodes[b];
        double width = graph_.turned ? box.size.height : box.size.width;
        double height = graph_.turned ? box.size.width : box.size.height;
        const auto slots = static_cast<double>(std::max(node.up.size(), node.down.size()));
        if (!box.round) width = std::max(width, (slots - 1) * distance::slots + 2 * distance::slot_margin);
        double stacked = loop_margin;
        for (const std::size_t e : loops) {
            const Size& label = level_.edges[e].label;
            stacked += loop_height(label) + loop_gap;
            node.loops = std::max(node.loops, loop_reach + (label.empty() ? 0 : distance::label + label.width));
        }
        if (!loops.empty()) height = std::max(height, stacked - loop_gap + loop_margin);
        node.before = width / 2;
        node.after = width / 2 + node.loops;
        node.above = node.below = height / 2;
    }

    void size_box_with_ports(std::size_t b) {
        const Box& box = level_.boxes[b];
        Node& node = graph_.nodes[b];
        double labels[2] = {0, 0};
        std::size_t count[2] = {0, 0};
        for (std::size_t p = 0; p < box.ports.size(); ++p) {
            const std::size_t side = graph_.ports[b][p].down ? 1 : 0;
            labels[side] = std::max(labels[side], box.ports[p].label_width);
            ++count[side];
        }
        const auto most = static_cast<double>(std::max(count[0], count[1]));
        const double height =
            box.on_border
                ? port_size
                : std::max(box.size.height, box.port_start + (most - 1) * distance::ports + 2 * distance::port_margin);
        const double inside = labels[0] + labels[1];
        const double width =
            inside > 0 ? std::max(box.size.width, inside + port_size + 3 * distance::slot_margin) : box.size.width;
        node.before = node.after = height / 2;
        node.ports_above = count[0] > 0 ? port_size / 2 : 0;
        node.ports_below = count[1] > 0 ? port_size / 2 : 0;
        node.above = width / 2 + node.ports_above;
        node.below = width / 2 + node.ports_below;
    }

    Graph& graph_;
    const Level& level_;
};

}  // namespace

void make_nodes(Graph& graph) {
    NodeMaker(graph).make_all();
}

}  // namespace robochart::diagrams::layout
