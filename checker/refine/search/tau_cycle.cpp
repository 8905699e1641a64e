// Strongly connected components by Tarjan's algorithm (1972), with a stack of our own.
#include "checker/refine/search/tau_cycle.hpp"

#include <algorithm>
#include <vector>

namespace robochart::refine {

using lts::no_state;
using lts::StateIndex;

namespace {

/// Follows edges from the entrances and returns those entrances to which one of the edges met leads back. A cycle has
/// such an edge, and its vertices are all met, so what is left out lies on none.
std::vector<StateIndex> entered_again(const GraphView& graph, const std::vector<StateIndex>& entrances) {
    std::vector<bool> met(graph.size, false);
    std::vector<StateIndex> waiting;
    std::vector<StateIndex> targets;
    BackTargets again;
    const auto meet = [&](StateIndex vertex) {
        if (met[vertex]) return;
        met[vertex] = true;
        waiting.push_back(vertex);
    };
    for (const StateIndex entrance : entrances) meet(entrance);
    while (!waiting.empty()) {
        const StateIndex vertex = waiting.back();
        waiting.pop_back();
        targets.clear();
        graph.successors(vertex, targets);
        for (const StateIndex target : targets) {
            again.note(vertex, target);
            meet(target);
        }
    }
    return again.list();
}

/// An edge is made once, when its source is entered; only those to vertices not yet entered are kept, and only while
/// the source is on the path.
class Tarjan {
public:
    explicit Tarjan(const GraphView& graph) : graph_(graph), number_(graph.size, 0), low_(graph.size, 0) {}

    std::optional<StateIndex> least_on_cycle(const std::vector<StateIndex>& entrances) {
        for (const StateIndex root : entrances)
            if (number_[root] == 0) explore(root);
        return least_ == no_state ? std::nullopt : std::optional(least_);
    }

private:
    struct Frame {
        StateIndex vertex;
        std::size_t first;  // of its targets in ahead_
    };

    void explore(StateIndex root) {
        enter(root);
        while (!path_.empty()) {
            if (ahead_.size() == path_.back().first) {
                leave();
                continue;
            }
            const StateIndex target = ahead_.back();
            ahead_.pop_back();
            if (!known(path_.back().vertex, target)) enter(target);
        }
    }

    void enter(StateIndex vertex) {
        number_[vertex] = low_[vertex] = ++count_;
        path_.push_back({vertex, ahead_.size()});
        component_.push_back(vertex);
        targets_.clear();
        graph_.successors(vertex, targets_);
        for (const StateIndex target : targets_)
            if (!known(vertex, target)) ahead_.push_back(target);
    }

    /// Whether the target was entered before; then that is all there is to the edge.
    bool known(StateIndex from, StateIndex to) {
        if (number_[to] == 0) return false;
        if (low_[to] != closed) low_[from] = std::min(low_[from], number_[to]);
        if (from == to) least_ = std::min(least_, from);
        return true;
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
    std::vector<StateIndex> ahead_;  // targets of the path's vertices
    std::vector<StateIndex> targets_;
    std::vector<StateIndex> component_;
    std::uint32_t count_ = 0;
    StateIndex least_ = no_state;
};

}  // namespace

void BackTargets::add(StateIndex vertex) {
    if (vertex >= marked_.size()) marked_.resize(vertex + std::size_t{1}, false);
    marked_[vertex] = true;
}

std::vector<StateIndex> BackTargets::list() const {
    std::vector<StateIndex> list;
    for (std::size_t vertex = 0; vertex < marked_.size(); ++vertex)
        if (marked_[vertex]) list.push_back(static_cast<StateIndex>(vertex));
    return list;
}

/// First entrances are left out as long as that is worth its while: most systems without divergence have none left.
std::optional<StateIndex> least_on_cycle(const GraphView& graph, std::vector<StateIndex> entrances) {
    for (std::size_t before = 0; !entrances.empty();) {
        before = entrances.size();
        entrances = entered_again(graph, entrances);
        if (entrances.size() > before / 2) return Tarjan(graph).least_on_cycle(entrances);
    }
    return std::nullopt;
}

std::vector<StateIndex> shortest_cycle(const GraphView& graph, StateIndex through) {
    std::vector<StateIndex> parent(graph.size, no_state);
    std::vector<StateIndex> queue{through};
    std::vector<StateIndex> targets;
    for (std::size_t next = 0; next < queue.size() && parent[through] == no_state; ++next) {
        targets.clear();
        graph.successors(queue[next], targets);
        for (const StateIndex target : targets) {
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
