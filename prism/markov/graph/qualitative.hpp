// SPDX-License-Identifier: Apache-2.0
// Decides on the graph, without computing numbers, which states reach a set with probability 0 or 1. Also decides CTL.
// Baier and Katoen, Principles of Model Checking, 10.1 and 10.6; Forejt et al., Automated Verification Techniques for
// Probabilistic Systems, 2011, figures 3 to 6.
#pragma once

#include "prism/markov/graph/graph.hpp"

namespace robochart::markov {

/// Returns the states in which `left U right` has maximal probability 0: the event is impossible under every scheduler.
/// In a dtmc, the probability is 0.
[[nodiscard]] StateSet prob0a(const Graph& graph, const StateSet& left, const StateSet& right);
/// Returns the states in which the minimal probability is 0: the event is impossible under some scheduler.
[[nodiscard]] StateSet prob0e(const Graph& graph, const StateSet& left, const StateSet& right);
/// Returns the states in which the maximal probability is 1: the event is almost sure under some scheduler. In a dtmc,
/// the probability is 1.
[[nodiscard]] StateSet prob1e(const Graph& graph, const StateSet& left, const StateSet& right);
/// Like the function above, for schedulers that use only the given choices. `choices` has one element for each choice.
[[nodiscard]] StateSet prob1e(const Graph& graph, const StateSet& left, const StateSet& right,
                              const std::vector<bool>& choices);
/// Returns the states in which the minimal probability is 1: the event is almost sure under every scheduler.
[[nodiscard]] StateSet prob1a(const Graph& graph, const StateSet& left, const StateSet& right);

/// The following functions decide CTL. A path is any infinite sequence of branches with positive probability, for any
/// resolution of choices.
[[nodiscard]] StateSet exists_next(const Graph& graph, const StateSet& set);
[[nodiscard]] StateSet always_next(const Graph& graph, const StateSet& set);
[[nodiscard]] StateSet exists_until(const Graph& graph, const StateSet& left, const StateSet& right);
[[nodiscard]] StateSet always_until(const Graph& graph, const StateSet& left, const StateSet& right);
[[nodiscard]] StateSet exists_finally(const Graph& graph, const StateSet& set);
[[nodiscard]] StateSet always_finally(const Graph& graph, const StateSet& set);
[[nodiscard]] StateSet exists_globally(const Graph& graph, const StateSet& set);
[[nodiscard]] StateSet always_globally(const Graph& graph, const StateSet& set);

}  // namespace robochart::markov
