// Which edges are drawn against their direction: those that lead back in a search in depth from the entries, their
// targets in the order of the text. Before an edit some edges led upwards already: these are turned first.
#include <algorithm>
#include <numeric>
#include <utility>

#include "diagrams/layout/graph.hpp"

namespace robochart::diagrams::layout {
namespace {

bool led_upwards(const Level& level, const Edge& edge) {
    const auto& from = level.boxes[edge.from].previous;
    const auto& to = level.boxes[edge.to].previous;
    return from && to && from->layer > to->layer;
}

/// An end that is pinned decides alone.
bool pinned_upwards(const Level& level, const Edge& edge) {
    return level.boxes[edge.to].pin == Pin::first || level.boxes[edge.from].pin == Pin::last;
}

/// The search in depth, without recursion: a level may be as deep as it has boxes.
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
        enter(box);
        while (!path_.empty()) step();
    }

private:
    enum class State : unsigned char { unseen, on_path, done };

    void enter(std::size_t box) {
        state_[box] = State::on_path;
        path_.emplace_back(box, 0);
        graph_.poll();
    }

    void step() {
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
        if (state_[target] == State::unseen) enter(target);
    }

    Graph& graph_;
    std::vector<std::vector<std::size_t>> out_;
    std::vector<State> state_;
    std::vector<std::pair<std::size_t, std::size_t>> path_;  ///< a box, and which of its edges is next
};

}  // namespace

void break_cycles(Graph& graph) {
    const Level& level = *graph.level;
    graph.reversed.assign(level.edges.size(), false);
    for (std::size_t e = 0; e < level.edges.size(); ++e)
        graph.reversed[e] = pinned_upwards(level, level.edges[e]) || led_upwards(level, level.edges[e]);
    DepthFirst search(graph);
    for (std::size_t b = 0; b < level.boxes.size(); ++b)
        if (level.boxes[b].entry) search.search_from(b);
    for (std::size_t b = 0; b < level.boxes.size(); ++b) search.search_from(b);
}

}  // namespace robochart::diagrams::layout
