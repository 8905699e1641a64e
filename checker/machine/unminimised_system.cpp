// SPDX-License-Identifier: Apache-2.0
#include "checker/machine/unminimised_system.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "checker/lts/bisimulation.hpp"

namespace robochart::machine {
namespace {

/// Adds the states of the component to the graph. Leaves out edges whose events are not in `events`.
void add_states(const Component& component, const EventSet& events, lts::StateIndex first, lts::Graph& graph) {
    for (Local state = 0; state < component.size(); ++state) {
        for (const Component::Edge& edge : component.edges(state))
            if (std::ranges::binary_search(events, component.alphabet()[edge.event]))
                graph.add_edge({component.alphabet()[edge.event], first + edge.target});
        graph.finish_state();
    }
}

}  // namespace

/// Minimises both components as one graph. A new root has a different transition to each of them. No two states of
/// `minimised` are bisimilar, so a state has at most one image there.
std::optional<StateMap> StateMap::make(const Component& component, const Component& minimised,
                                       diagnostics::Pollable& budget) {
    const auto size = static_cast<Local>(component.size());
    std::vector<Local> images(size, 0);
    if (size == minimised.size()) {  // nothing was merged, so all numbers are the same
        std::iota(images.begin(), images.end(), 0U);
        return StateMap(std::move(images), size);
    }
    lts::Graph both;
    both.add_edge({0, 1});
    both.add_edge({1, 1 + size});
    both.finish_state();
    add_states(component, minimised.alphabet(), 1, both);
    add_states(minimised, minimised.alphabet(), 1 + size, both);
    const lts::Quotient quotient = lts::minimise(both, lts::Equivalence::strong, budget);
    std::vector<Local> by_class(quotient.graph.size(), static_cast<Local>(minimised.size()));
    for (Local state = 0; state < minimised.size(); ++state) by_class[quotient.state_of[1 + size + state]] = state;
    for (Local state = 0; state < size; ++state) {
        const lts::StateIndex found = quotient.state_of[1 + state];
        if (found == lts::no_state) continue;
        if (by_class[found] == minimised.size()) return std::nullopt;
        images[state] = by_class[found];
    }
    return StateMap(std::move(images), static_cast<Local>(minimised.size()));
}

void UnminimisedSystem::minimised_state(lts::StateView state, std::span<lts::Word> minimised) const {
    assert(minimised.size() == minimised_->words);
    std::ranges::fill(minimised, 0);
    for (std::size_t slot = 0; slot < maps_.size(); ++slot)
        minimised_->fields[slot].put(minimised, maps_[slot].image(combined_->fields[slot].get(state)));
}

}  // namespace robochart::machine
