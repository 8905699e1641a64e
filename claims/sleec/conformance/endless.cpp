// SPDX-License-Identifier: Apache-2.0
// See endless.hpp.
#include "claims/sleec/conformance/endless.hpp"

#include <algorithm>
#include <deque>

#include "checker/lts/strong_components.hpp"

namespace robochart::sleec {
namespace {

using lts::Edge;

using lts::Graph;
using lts::StateIndex;

constexpr std::uint32_t nowhere = ~std::uint32_t{0};

/// Returns the number of the strongly connected component of each state.
std::vector<std::uint32_t> components_of(const Graph& graph) {
    std::vector<std::uint32_t> result(graph.size(), nowhere);
    std::uint32_t next = 0;
    const lts::GraphView view{graph.size(), [&](StateIndex state, std::vector<StateIndex>& targets) {
                                  for (const Edge& edge : graph.edges(state)) targets.push_back(edge.target);
                              }};
    const std::vector<StateIndex> roots{0};
    lts::strong_components(view, roots, [&](std::span<const StateIndex> members, bool) {
        for (const StateIndex member : members) result[member] = next;
        ++next;
    });
    return result;
}

/// Returns the edges of a shortest path from one state to another through admitted states.
template <class Admitted>
std::vector<std::pair<StateIndex, Edge>> find_way(const Graph& graph, StateIndex from, StateIndex to,
                                                  const Admitted& admitted) {
    std::vector<std::pair<StateIndex, Edge>> result;
    if (from == to) return result;
    std::vector<std::pair<StateIndex, Edge>> reached(graph.size(), {nowhere, {}});
    std::deque<StateIndex> waiting{from};
    while (!waiting.empty() && reached[to].first == nowhere) {
        const StateIndex state = waiting.front();
        waiting.pop_front();
        for (const Edge& edge : graph.edges(state)) {
            if (edge.target == from || reached[edge.target].first != nowhere || !admitted(edge.target)) continue;
            reached[edge.target] = {state, edge};
            waiting.push_back(edge.target);
        }
    }
    for (StateIndex at = to; at != from; at = reached[at].first) result.push_back(reached[at]);
    std::ranges::reverse(result);
    return result;
}

/// Collects the hidden events of the taus of one state.
class Revealing final : public lts::SuccessorSink {
public:
    Revealing(const lts::StateStore& states, const Edge& edge) : states_(states), edge_(edge) {}
    void add(lts::Event event, lts::StateView target, lts::Event revealed) override {
        const lts::StateView view = states_[edge_.target];
        if (!found_ && event == edge_.event && std::ranges::equal(target, view)) found_ = revealed;
    }
    [[nodiscard]] lts::Event revealed_event() const { return found_.value_or(edge_.event); }

private:
    const lts::StateStore& states_;
    const Edge& edge_;
    std::optional<lts::Event> found_;
};

}  // namespace

std::optional<EndlessRun> endless_run(lts::TransitionSystem& system, lts::Event event,
                                      const std::function<void(std::size_t states)>& on_state) {
    const lts::Exploration explored = lts::explore(system, on_state);
    const Graph& graph = explored.graph;
    const std::vector<std::uint32_t> component = components_of(graph);
    const auto revealed = [&](const std::vector<std::pair<StateIndex, Edge>>& edges) {
        std::vector<EndlessStep> result;
        for (const auto& [state, edge] : edges) {
            Revealing sink(explored.states, edge);
            system.successors(explored.states[state], sink);
            result.push_back({edge.event, sink.revealed_event()});
        }
        return result;
    };
    for (StateIndex state = 0; state < graph.size(); ++state)
        for (const Edge& edge : graph.edges(state)) {
            if (edge.event != event || component[edge.target] != component[state]) continue;
            std::vector<std::pair<StateIndex, Edge>> loop{{state, edge}};
            const auto back =
                find_way(graph, edge.target, state, [&](StateIndex at) { return component[at] == component[state]; });
            loop.insert(loop.end(), back.begin(), back.end());
            return EndlessRun{revealed(find_way(graph, 0, state, [](StateIndex) { return true; })), revealed(loop)};
        }
    return std::nullopt;
}

}  // namespace robochart::sleec
