// SPDX-License-Identifier: Apache-2.0
#include "checker/lts/tau_components.hpp"

#include <cassert>
#include <numeric>

#include "base/diagnostics/containers.hpp"
#include "checker/lts/strong_components.hpp"

namespace robochart::lts {

TauComponents tau_components(const Graph& graph) {
    TauComponents result{std::vector<StateIndex>(graph.size(), no_state), {}};
    const GraphView taus{graph.size(), [&](StateIndex state, std::vector<StateIndex>& targets) {
                             for (const Edge& edge : graph.edges(state))
                                 if (edge.event == tau) targets.push_back(edge.target);
                         }};
    std::vector<StateIndex> states(graph.size());
    std::iota(states.begin(), states.end(), StateIndex{0});
    strong_components(taus, states, [&](std::span<const StateIndex> members, bool cyclic) {
        const auto number = static_cast<StateIndex>(result.cyclic.size());
        result.cyclic.push_back(cyclic);
        for (const StateIndex member : members) result.component[member] = number;
    });
    return result;
}

TauComponents every_state_alone(const Graph& graph) {
    TauComponents result{{}, std::vector<bool>(graph.size(), false)};
    for (StateIndex state = 0; state < graph.size(); ++state) result.component.push_back(state);
    return result;
}

Graph contract_components(const Graph& graph, const TauComponents& components) {
    assert(components.component.size() == graph.size());
    std::vector<std::vector<StateIndex>> members(components.cyclic.size());
    for (StateIndex state = 0; state < graph.size(); ++state) members[components.component[state]].push_back(state);
    Graph result;
    for (StateIndex component = 0; component < members.size(); ++component) {
        std::vector<Edge> edges;
        if (components.cyclic[component]) edges.push_back({tau, component});
        for (StateIndex state : members[component])
            for (const Edge& edge : graph.edges(state)) {
                const StateIndex target = components.component[edge.target];
                assert(edge.event != tau || target <= component);  // see strong_components for their order
                if (edge.event != tau || target != component) edges.push_back({edge.event, target});
            }
        diagnostics::sort_unique(edges);
        for (const Edge& edge : edges) result.add_edge(edge);
        result.finish_state();
    }
    return result;
}

}  // namespace robochart::lts
