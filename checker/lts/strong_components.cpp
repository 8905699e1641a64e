// SPDX-License-Identifier: Apache-2.0
#include "checker/lts/strong_components.hpp"

#include <algorithm>
#include <cassert>

namespace robochart::lts {
namespace {

/// Tarjan's algorithm. To save memory, it stores an edge only while its source is on the current path, and only if its
/// target was not yet visited.
class Tarjan {
public:
    Tarjan(const GraphView& graph, const OnComponent& report)
        : graph_(graph), report_(report), number_(graph.size, 0), low_(graph.size, 0) {}

    void explore(StateIndex root) {
        assert(path_.empty() && ahead_.empty() && open_.empty());
        if (number_[root] != 0) return;
        enter_vertex(root);
        while (!path_.empty()) {
            if (ahead_.size() == path_.back().first) {
                leave_vertex();
                continue;
            }
            const StateIndex target = ahead_.back();
            ahead_.pop_back();
            if (!process_if_entered(target)) enter_vertex(target);
        }
    }

private:
    struct Frame {
        StateIndex vertex;
        bool loops;         // the vertex has an edge to itself
        std::size_t first;  // index of the first of its targets in ahead_
    };

    void enter_vertex(StateIndex vertex) {
        assert(number_[vertex] == 0);
        number_[vertex] = low_[vertex] = ++count_;
        path_.push_back({vertex, false, ahead_.size()});
        open_.push_back(vertex);
        targets_.clear();
        graph_.successors(vertex, targets_);
        // The last vertex of the path takes its targets from the end of ahead_.
        for (auto target = targets_.rbegin(); target != targets_.rend(); ++target)
            if (!process_if_entered(*target)) ahead_.push_back(*target);
    }

    /// If the vertex `to` has been visited, processes the edge from the end of the path to `to` and returns true.
    bool process_if_entered(StateIndex to) {
        if (number_[to] == 0) return false;
        assert(!path_.empty());
        Frame& from = path_.back();
        if (low_[to] != closed) low_[from.vertex] = std::min(low_[from.vertex], number_[to]);
        from.loops |= from.vertex == to;
        return true;
    }

    void leave_vertex() {
        const Frame left = path_.back();
        path_.pop_back();
        const std::uint32_t low = low_[left.vertex];
        assert(low != closed && low <= number_[left.vertex]);
        if (!path_.empty()) low_[path_.back().vertex] = std::min(low_[path_.back().vertex], low);
        if (low == number_[left.vertex]) close_component(left);
    }

    void close_component(const Frame& root) {
        assert(!open_.empty() && low_[root.vertex] == number_[root.vertex]);
        std::size_t begin = open_.size();
        do low_[open_[--begin]] = closed;
        while (open_[begin] != root.vertex);
        const std::span<const StateIndex> members = std::span(open_).subspan(begin);
        report_(members, members.size() > 1 || root.loops);
        open_.resize(begin);
    }

    static constexpr std::uint32_t closed = no_state;
    const GraphView& graph_;
    const OnComponent& report_;
    std::vector<std::uint32_t> number_;  // by vertex: when it was first visited, counted from 1
    std::vector<std::uint32_t> low_;
    std::vector<Frame> path_;
    std::vector<StateIndex> ahead_;  // for all vertices on the path: edges that must still be followed
    std::vector<StateIndex> targets_;
    std::vector<StateIndex> open_;  // visited vertices whose component is not yet complete
    std::uint32_t count_ = 0;
};

}  // namespace

void strong_components(const GraphView& graph, std::span<const StateIndex> roots, const OnComponent& report) {
    Tarjan tarjan(graph, report);
    for (const StateIndex root : roots) tarjan.explore(root);
}

}  // namespace robochart::lts
