// SPDX-License-Identifier: Apache-2.0
// Decides without numbers which states reach a set with probability 0 or 1, and CTL over the graph. Baier and Katoen,
// Principles of Model Checking, 10.1 and 10.6; Forejt et al., Automated Verification Techniques for Probabilistic
// Systems, 2011, figures 3 to 6.
#pragma once

#include "prism/markov/graph/graph.hpp"

namespace robochart::markov {

/// States in which `left U right` has maximal probability 0: the event is impossible under every scheduler. For a dtmc:
/// probability 0.
[[nodiscard]] StateSet prob0a(const Graph& graph, const StateSet& left, const StateSet& right);
/// States in which the minimal probability is 0: the event is impossible under some scheduler.
[[nodiscard]] StateSet prob0e(const Graph& graph, const StateSet& left, const StateSet& right);
/// States in which the maximal probability is 1: the event is almost sure under some scheduler. For a dtmc: probability
/// 1.
[[nodiscard]] StateSet prob1e(const Graph& graph, const StateSet& left, const StateSet& right);
/// Maximal probability 1 for schedulers that use only the given choices. `choices` has one element for each choice.
[[nodiscard]] StateSet prob1e(const Graph& graph, const StateSet& left, const StateSet& right,
                              const std::vector<bool>& choices);
/// States in which the minimal probability is 1: the event is almost sure under every scheduler.
[[nodiscard]] StateSet prob1a(const Graph& graph, const StateSet& left, const StateSet& right);

/// CTL: a path is any infinite sequence of branches with positive probability, for all resolutions of choices.
[[nodiscard]] StateSet exists_next(const Graph& graph, const StateSet& set);
[[nodiscard]] StateSet always_next(const Graph& graph, const StateSet& set);
[[nodiscard]] StateSet exists_until(const Graph& graph, const StateSet& left, const StateSet& right);
[[nodiscard]] StateSet always_until(const Graph& graph, const StateSet& left, const StateSet& right);
[[nodiscard]] StateSet exists_finally(const Graph& graph, const StateSet& set);
[[nodiscard]] StateSet always_finally(const Graph& graph, const StateSet& set);
[[nodiscard]] StateSet exists_globally(const Graph& graph, const StateSet& set);
[[nodiscard]] StateSet always_globally(const Graph& graph, const StateSet& set);

}  // namespace robochart::markov
