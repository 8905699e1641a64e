// SPDX-License-Identifier: Apache-2.0
// Decides whether two explored systems are bisimilar.
#pragma once

#include <stdexcept>
#include <utility>

#include "checker/lts/bisimulation.hpp"

namespace robochart::lts {

struct TooLarge : std::length_error {
    TooLarge() : std::length_error("too many states to compare") {}
};

/// Returns all transitions of a system as a graph. Throws TooLarge.
inline Graph graph_of(TransitionSystem& system, std::size_t most_states) {
    return explore(system,
                   [most_states](std::size_t states) {
                       if (states > most_states) throw TooLarge();
                   })
        .graph;
}

/// Minimises the union of both graphs, and compares the classes of their initial states.
inline bool are_bisimilar(const Graph& a, const Graph& b, Equivalence equivalence = Equivalence::strong) {
    Graph both;
    const auto after = static_cast<StateIndex>(1 + a.size());
    both.add_edge({2, 1});
    both.add_edge({3, after});
    both.finish_state();
    const auto append = [&both](const Graph& graph, StateIndex offset) {
        for (StateIndex state = 0; state < graph.size(); ++state) {
            for (const Edge& edge : graph.edges(state)) both.add_edge({edge.event, edge.target + offset});
            both.finish_state();
        }
    };
    append(a, 1);
    append(b, after);
    const Quotient quotient = minimise(both, equivalence);
    return quotient.state_of[1] == quotient.state_of[after];
}

}  // namespace robochart::lts
