// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/search/tau_cycle.hpp"

#include <algorithm>
#include <cassert>
#include <vector>

namespace robochart::refine {

using lts::no_state;
using lts::StateIndex;

namespace {

/// Follows edges from the entrances, and returns the entrances to which a visited edge leads back. A cycle that
/// contains an entrance is visited completely, and one of its edges leads back. So it also contains an entrance that is
/// returned.
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
            again.note_tau(vertex, target);
            meet(target);
        }
    }
    return again.list();
}

/// Returns the least vertex of a cyclic component among the vertices that the entrances reach.
std::optional<StateIndex> least_in_cyclic_component(const GraphView& graph, const std::vector<StateIndex>& entrances) {
    StateIndex least = no_state;
    lts::strong_components(graph, entrances, [&](std::span<const StateIndex> members, bool cyclic) {
        if (cyclic) least = std::min(least, *std::ranges::min_element(members));
    });
    return least == no_state ? std::nullopt : std::optional(least);
}

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

/// Eliminates entrances in rounds as long as this pays off, and then searches from the others. For most systems without
/// divergence no entrance remains.
std::optional<StateIndex> least_on_cycle(const GraphView& graph, std::vector<StateIndex> entrances) {
    for (std::size_t before = 0; !entrances.empty();) {
        before = entrances.size();
        entrances = entered_again(graph, entrances);
        if (entrances.size() > before / 2) return least_in_cyclic_component(graph, entrances);
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
    std::ranges::reverse(cycle);
    assert(cycle.back() == through);
    return cycle;
}

}  // namespace robochart::refine
