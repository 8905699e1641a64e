// Strongly connected components by Tarjan's algorithm (1972), with a stack of our own.
#include "checker/refine/tau_cycle.hpp"

#include <algorithm>
#include <vector>

namespace robochart::refine {

using lts::no_state;
using lts::StateIndex;

namespace {

class Tarjan {
public:
    explicit Tarjan(const GraphView& graph) : graph_(graph), number_(graph.size, 0), low_(graph.size, 0) {}

    std::optional<StateIndex> least_on_cycle() {
        for (StateIndex root = 0; root < graph_.size; ++root)
            if (number_[root] == 0 && graph_.edge(root, 0) != no_state) explore(root);
        return least_ == no_state ? std::nullopt : std::optional(least_);
    }

private:
    struct Frame {
        StateIndex vertex;
        std::size_t next;
    };

    void explore(StateIndex root) {
        enter(root);
        while (!path_.empty()) {
            Frame& top = path_.back();
            const StateIndex target = graph_.edge(top.vertex, top.next++);
            if (target == no_state)
                leave();
            else if (number_[target] == 0)
                enter(target);
            else if (low_[target] != closed)
                note_back_edge(top.vertex, target);
        }
    }

    void enter(StateIndex vertex) {
        number_[vertex] = low_[vertex] = ++count_;
        path_.push_back({vertex, 0});
        component_.push_back(vertex);
    }

    void note_back_edge(StateIndex from, StateIndex to) {
        low_[from] = std::min(low_[from], number_[to]);
        if (from == to) least_ = std::min(least_, from);
    }

    void leave() {
        const StateIndex vertex = path_.back().vertex;
        path_.pop_back();
        if (!path_.empty()) low_[path_.back().vertex] = std::min(low_[path_.back().vertex], low_[vertex]);
        if (low_[vertex] == number_[vertex]) close_component(vertex);
    }

    void close_component(StateIndex root) {
        const bool alone = component_.back() == root;
        for (StateIndex member = no_state; member != root;) {
            member = component_.back();
            component_.pop_back();
            low_[member] = closed;
            if (!alone) least_ = std::min(least_, member);
        }
    }

    static constexpr std::uint32_t closed = no_state;
    const GraphView& graph_;
    std::vector<std::uint32_t> number_;  // order of entering, from 1
    std::vector<std::uint32_t> low_;
    std::vector<Frame> path_;
    std::vector<StateIndex> component_;
    std::uint32_t count_ = 0;
    StateIndex least_ = no_state;
};

}  // namespace

std::optional<StateIndex> least_on_cycle(const GraphView& graph) {
    return Tarjan(graph).least_on_cycle();
}

std::vector<StateIndex> shortest_cycle(const GraphView& graph, StateIndex through) {
    std::vector<StateIndex> parent(graph.size, no_state);
    std::vector<StateIndex> queue{through};
    for (std::size_t next = 0; next < queue.size() && parent[through] == no_state; ++next) {
        StateIndex target = 0;
        for (std::size_t i = 0; (target = graph.edge(queue[next], i)) != no_state; ++i) {
            if (parent[target] != no_state) continue;
            parent[target] = queue[next];
            queue.push_back(target);
        }
    }
    std::vector<StateIndex> cycle;
    if (parent[through] == no_state) return cycle;
    for (StateIndex vertex = through; cycle.empty() || vertex != through; vertex = parent[vertex])
        cycle.push_back(vertex);
    std::reverse(cycle.begin(), cycle.end());
    return cycle;
}

}  // namespace robochart::refine
