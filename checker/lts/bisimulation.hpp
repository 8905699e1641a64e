// Minimisation by partition refinement with signatures (Blom and Orzan, 2003; Wimmer et al., "Sigref", 2006).
#pragma once

#include <functional>
#include <vector>

#include "checker/lts/graph.hpp"

namespace robochart::lts {

/// Which states count as equal.
enum class Equivalence {
    /// Strong bisimilarity: keeps everything.
    strong,
    /// Branching bisimilarity that respects divergence (van Glabbeek, Luttik, Trcka 2009). Finer than FDR's dbisim and
    /// wbisim. CSP's operators do not resolve on tau, so it is a congruence for them; prioritise included, because a
    /// state without an inert tau offers all that the states leading to it by inert taus offer, and a state on a tau
    /// cycle keeps a tau. Keeps T, F and FD.
    branching_with_divergence,
};

/// The smallest graph equivalent to another, and which states became which.
struct Quotient {
    Graph graph;                             ///< numbered breadth first; edges ordered, without repetitions
    std::vector<StateIndex> representative;  ///< of each state, the first state of the original that it stands for
    std::vector<StateIndex> state_of;        ///< of each original state reachable or not; no_state if not reachable
};

/// `poll`, if any, is called now and then and may throw to stop.
[[nodiscard]] Quotient minimise(const Graph& graph, Equivalence equivalence, const std::function<void()>& poll = {});

}  // namespace robochart::lts
