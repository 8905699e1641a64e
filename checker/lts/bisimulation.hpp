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
    /// Branching bisimilarity with explicit divergence (van Glabbeek, Luttik, Trcka 2009). This equivalence is finer
    /// than FDR's dbisim and wbisim. It preserves T, F and FD. It is a congruence for the operators of CSP, because a
    /// tau of an operand resolves no operator. For prioritise, there are two more reasons: a state without an inert tau
    /// offers all events of the states from which inert taus lead to it, and a state on a tau cycle still has a tau in
    /// the quotient.
    branching_with_divergence,
};

/// The smallest graph that is equivalent to a given graph (the original), and a mapping between the states of the two
/// graphs.
struct Quotient {
    Graph graph;                             ///< numbered in breadth-first order; edges sorted, without duplicates
    std::vector<StateIndex> representative;  ///< by state: the first original state in its class
    std::vector<StateIndex> state_of;        ///< by original state; no_state if it is not reachable
};

/// Returns the quotient of the graph by the equivalence. Polls the budget.
[[nodiscard]] Quotient minimise(const Graph& graph, Equivalence equivalence,
                                diagnostics::Pollable& budget = diagnostics::unlimited);

}  // namespace robochart::lts
