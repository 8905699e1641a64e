// SPDX-License-Identifier: Apache-2.0
// Minimises graphs by partition refinement with signatures (Blom and Orzan, 2003; Wimmer et al., "Sigref", 2006).
#pragma once

#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/lts/graph.hpp"

namespace robochart::lts {

/// The equivalences for minimising a graph.
enum class Equivalence {
    /// Strong bisimilarity: preserves all models.
    strong,
    /// Branching bisimilarity with explicit divergence (van Glabbeek, Luttik, Trcka 2009). It is finer than FDR's
    /// dbisim and wbisim. It preserves T, F and FD. It is a congruence for the operators of CSP, because a tau of an
    /// operand resolves none of them. For prioritise, there are two more reasons. A state without an inert tau offers
    /// all events of the states from which inert taus lead to it. And a state on a tau cycle still has a tau in the
    /// quotient.
    branching_with_divergence,
};

/// The smallest graph that is equivalent to another graph (the original), and which states of the two graphs correspond
/// to each other.
struct Quotient {
    Graph graph;                             ///< numbered in breadth-first order; edges sorted, without duplicates
    std::vector<StateIndex> representative;  ///< by state: the first original state that it represents
    std::vector<StateIndex> state_of;        ///< by original state; no_state if the state is not reachable
};

/// Returns the quotient of the graph by the equivalence. Polls the budget.
[[nodiscard]] Quotient minimise(const Graph& graph, Equivalence equivalence,
                                diagnostics::Pollable& budget = diagnostics::unlimited);

}  // namespace robochart::lts
