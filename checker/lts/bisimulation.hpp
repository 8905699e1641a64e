// SPDX-License-Identifier: Apache-2.0
// Minimisation by partition refinement with signatures (Blom and Orzan, 2003; Wimmer et al., "Sigref", 2006).
#pragma once

#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/lts/graph.hpp"

namespace robochart::lts {

/// The equivalences.
enum class Equivalence {
    /// Strong bisimilarity: preserves all models.
    strong,
    /// Branching bisimilarity that respects divergence (van Glabbeek, Luttik, Trcka 2009). Finer than FDR's dbisim and
    /// wbisim. CSP's operators do not resolve on tau, so it is a congruence for them. This includes prioritise, because
    /// a state without an inert tau offers all events of the states that lead to it by inert taus, and a state on a tau
    /// cycle keeps a tau. Preserves T, F and FD.
    branching_with_divergence,
};

/// The smallest graph equivalent to another, and the mapping between their states.
struct Quotient {
    Graph graph;                             ///< numbered in breadth-first order; edges sorted, without duplicates
    std::vector<StateIndex> representative;  ///< by state: the first original state that it represents
    std::vector<StateIndex> state_of;        ///< by original state; no_state if it is not reachable
};

/// Returns the quotient of the graph by the equivalence. Polls the budget.
[[nodiscard]] Quotient minimise(const Graph& graph, Equivalence equivalence,
                                diagnostics::Pollable& budget = diagnostics::unlimited);

}  // namespace robochart::lts
