// SPDX-License-Identifier: Apache-2.0
// Decides which edges are drawn against their direction. By default, these are the back edges of a depth-first search
// from the entries, with targets in textual order. After an edit, edges that led upwards before are reversed first. The
// method `kept` also reverses edges of added boxes, so that the other boxes can keep their places. The method `few`
// reverses few edges (P. Eades, X. Lin, W. Smyth: A fast and effective heuristic for the feedback arc set problem,
// 1993).
#include <algorithm>
#include <numeric>
#include <utility>

#include "frontend/diagrams/layout/graph.hpp"

namespace robochart::diagrams::layout {
namespace {

bool led_upwards(const Level& level, const Edge& edge) {
    const auto& from = level.boxes[edge.from].previous;
    const auto& to = level.boxes[edge.to].previous;
    return from && to && from->layer > to->layer;
}

/// True for an edge between a box that existed before an edit and a new box, if neither is pinned.
bool joins_added(const Level& level, const Edge& edge) {
    const Box& from = level.boxes[edge.from];
    const Box& to = level.boxes[edge.to];
    return from.pin == Pin::none && to.pin == Pin::none && from.previous.has_value() != to.previous.has_value();
}

/// True if a pinned end forces the edge to lead upwards.
bool pinned_upwards(const Level& level, const Edge& edge) {
    return level.boxes[edge.to].pin == Pin::first || level.boxes[edge.from].pin == Pin::last;
}

/// A depth-first search. It is iterative, because a path may be as long as the number of boxes.
class DepthFirst {
public:
    explicit DepthFirst(Graph& graph) : graph_(graph), out_(graph.level->boxes.size()), state_(out_.size()) {
        const Level& level = *graph.level;
        for (std::size_t e = 0; e < level.edges.size(); ++e) {
            const Edge& edge = level.edges[e];
            if (edge.from != edge.to) out_[graph.reversed[e] ? edge.to : edge.from].push_back(e);
        }
    }

    void search_from(std::size_t box) {
        if (state_[box] != State::unseen) return;
        enter_box(box);
        while (!path_.empty()) advance_path();
    }

private:
    enum class State : unsigned char { unseen, on_path, done };

    void enter_box(std::size_t box) {
        state_[box] = State::on_path;
        path_.emplace_back(box, 0);
        graph_.poll();
    }

    void advance_path() {
        auto& [box, next] = path_.back();
        if (next == out_[box].size()) {
            state_[box] = State::done;
            path_.pop_back();
            return;
        }
        const std::size_t e = out_[box][next++];
        const Edge& edge = graph_.level->edges[e];
        const std::size_t target = graph_.reversed[e] ? edge.from : edge.to;
        if (state_[target] == State::on_path) graph_.reversed[e] = !graph_.reversed[e];
        if (state_[target] == State::unseen) enter_box(target);
    }

    Graph& graph_;
    std::vector<std::vector<std::size_t>> out_;
    std::vector<State> state_;
    std::vector<std::pair<std::size_t, std::size_t>> path_;  ///< a box and the index of its next edge
};

/// An order of the boxes with few backward edges. Boxes without incoming edges come first, boxes without outgoing edges
/// last. If there is no such box, the box with the largest surplus of outgoing edges comes next. Textual order breaks
/// ties.
class GreedyOrder {
public:
    explicit GreedyOrder(const Graph& graph)
        : graph_(graph), near_(graph.level->boxes.size()), left_(near_.size(), true), places_(near_.size()) {
        const Level& level = *graph.level;
        for (std::size_t e = 0; e < level.edges.size(); ++e) {
            const auto [from, to] = ends_of(e);
            if (from == to) continue;
            near_[from].out.push_back(to);
            near_[to].in.push_back(from);
        }
        for (Near& near : near_) {
            near.outs = near.out.size();
            near.ins = near.in.size();
        }
    }

    /// Returns the position of each box.
    std::vector<std::size_t> compute_positions() {
        std::size_t first = 0;
        std::size_t behind = near_.size();
        while (first < behind) {
            graph_.poll();
            const std::size_t box = choose_next();
            const bool last = near_[box].outs == 0 && near_[box].ins > 0;
            places_[box] = last ? --behind : first++;
            remove_box(box);
        }
        return places_;
    }

    [[nodiscard]] std::pair<std::size_t, std::size_t> ends_of(std::size_t e) const {
        const Edge& edge = graph_.level->edges[e];
        return graph_.reversed[e] ? std::pair(edge.to, edge.from) : std::pair(edge.from, edge.to);
    }

private:
    struct Near {
        std::vector<std::size_t> in, out;
        std::size_t ins = 0, outs = 0;  ///< number of edges from and to boxes that remain
    };

    [[nodiscard]] std::size_t choose_next() const {
        std::size_t best = nothing;
        for (std::size_t box = 0; box < near_.size(); ++box) {
            if (!left_[box]) continue;
            if (near_[box].ins == 0 || near_[box].outs == 0) return box;
            if (best == nothing || near_[box].outs + near_[best].ins > near_[best].outs + near_[box].ins) best = box;
        }
        return best;
    }
    void remove_box(std::size_t box) {
        left_[box] = false;
        for (const std::size_t other : near_[box].out) --near_[other].ins;
        for (const std::size_t other : near_[box].in) --near_[other].outs;
    }

    const Graph& graph_;
    std::vector<Near> near_;
    std::vector<bool> left_;
    std::vector<std::size_t> places_;
};

void turn_few(Graph& graph) {
    GreedyOrder order(graph);
    const std::vector<std::size_t> places = order.compute_positions();
    for (std::size_t e = 0; e < graph.reversed.size(); ++e) {
        const auto [from, to] = order.ends_of(e);
        if (places[from] > places[to]) graph.reversed[e] = !graph.reversed[e];
    }
}

void turn_back_edges(Graph& graph) {
    const Level& level = *graph.level;
    DepthFirst search(graph);
    for (std::size_t b = 0; b < level.boxes.size(); ++b)
        if (level.boxes[b].entry) search.search_from(b);
    for (std::size_t b = 0; b < level.boxes.size(); ++b) search.search_from(b);
}

}  // namespace

void break_cycles(Graph& graph, Cycles cycles) {
    const Level& level = *graph.level;
    graph.reversed.assign(level.edges.size(), false);
    for (std::size_t e = 0; e < level.edges.size(); ++e) {
        const Edge& edge = level.edges[e];
        const bool turned = cycles == Cycles::kept && joins_added(level, edge);
        graph.reversed[e] = pinned_upwards(level, edge) || led_upwards(level, edge) || turned;
    }
    if (cycles == Cycles::few)
        turn_few(graph);
    else
        turn_back_edges(graph);
}

}  // namespace robochart::diagrams::layout
