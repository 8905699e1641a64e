// SPDX-License-Identifier: Apache-2.0
#include "checker/machine/explicit_machine.hpp"

#include <algorithm>
#include <cassert>

#include "base/diagnostics/containers.hpp"
#include "checker/lts/bisimulation.hpp"

namespace robochart::machine {

void minimise(ExplicitMachine& machine, diagnostics::Pollable& budget) {
    assert(machine.rows.size() == machine.meaning.size());
    lts::Graph graph;
    for (const auto& row : machine.rows) {
        for (const Component::RawEdge& edge : row) graph.add_edge({edge.event, edge.target});
        graph.finish_state();
    }
    const lts::Quotient quotient = lts::minimise(graph, lts::Equivalence::strong, budget);
    if (quotient.graph.size() == machine.rows.size()) return;
    ExplicitMachine smaller;
    for (const lts::StateIndex state : quotient.representative) {
        smaller.meaning.push_back(machine.meaning[state]);
        std::vector<Component::RawEdge> row = machine.rows[state];
        for (Component::RawEdge& edge : row) {
            edge.target = quotient.state_of[edge.target];
            assert(edge.target != lts::no_state);  // the source is reachable, so the target is, too
        }
        const auto key = [](const Component::RawEdge& edge) { return std::pair(edge.event, edge.target); };
        std::ranges::stable_sort(row, [&](const auto& a, const auto& b) { return key(a) < key(b); });
        const auto same = [&](const auto& a, const auto& b) { return key(a) == key(b); };
        diagnostics::erase_repeated(row, same);
        smaller.rows.push_back(std::move(row));
    }
    machine = std::move(smaller);
}

ExplicitMachine without_unused(const Component& component, const std::vector<bool>& used) {
    ExplicitMachine result;
    for (Local state = 0; state < component.size(); ++state) {
        result.meaning.push_back(component.term_of(state));
        auto& row = result.rows.emplace_back();
        for (const Component::Edge& edge : component.edges(state))
            if (used[edge.event]) row.push_back({component.alphabet()[edge.event], edge.revealed, edge.target});
    }
    return result;
}

}  // namespace robochart::machine
