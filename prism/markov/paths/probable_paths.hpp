// SPDX-License-Identifier: Apache-2.0
// Finds the most probable paths to a set of states, in descending order, as evidence that a probability exceeds a bound
// (Han, Katoen and Damman, Counterexample generation in probabilistic model checking, IEEE TSE 35, 2009).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "prism/markov/graph/graph.hpp"
#include "prism/markov/solve/enclosure.hpp"

namespace robochart::markov {

struct Path {
    std::vector<State> states;  ///< only the last state is in the goal
    Enclosure probability;
};

/// The requested paths: paths of `left U right` from a state. None is a prefix of another, so their probabilities add
/// up.
struct PathsWanted {
    const Graph& graph;
    const std::vector<std::uint32_t>& strategy;  ///< a choice for each state
    const StateSet& left;
    const StateSet& right;
    State from = 0;
    std::optional<std::uint64_t> steps;  ///< maximal length of a path
    double bound = 0;                    ///< bound on the total probability of the paths
    bool strict = true;                  ///< the total must exceed the bound, not only reach it
    std::size_t most = 10'000;           ///< maximal number of paths
    diagnostics::Budget* budget = nullptr;
};

struct PathSet {
    std::vector<Path> paths;  ///< the most probable first, up to rounding
    Enclosure total;          ///< sum of the paths' probabilities
    bool enough = false;      ///< the total reaches the bound in spite of rounding
};

/// Returns the most probable paths, as few as are needed for their total to reach the bound. If `most` paths cannot
/// reach it, the result contains only some of the paths. Throws LimitReached.
[[nodiscard]] PathSet probable_paths(const PathsWanted& request);

}  // namespace robochart::markov
