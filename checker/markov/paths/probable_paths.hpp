// The most probable paths to a set of states, one after the other: evidence that a probability exceeds a bound
// (Han, Katoen and Damman, Counterexample generation in probabilistic model checking, IEEE TSE 35, 2009).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "checker/markov/graph/graph.hpp"
#include "checker/markov/solve/enclosure.hpp"
#include "diagnostics/budget.hpp"

namespace robochart::markov {

struct Path {
    std::vector<State> states;  ///< the last one is the first in the goal
    Enclosure probability;
};

/// Paths of `left U right` from a state: no two of them begin alike, so their probabilities add up.
struct PathsWanted {
    const Graph& graph;
    const std::vector<std::uint32_t>& strategy;  ///< a choice of each state
    const StateSet& left;
    const StateSet& right;
    State from = 0;
    std::optional<std::uint64_t> steps;  ///< of a path at most
    double bound = 0;                    ///< what they are to reach together
    bool strict = true;                  ///< ... to exceed
    std::size_t most = 10'000;           ///< paths
    diagnostics::Budget* budget = nullptr;
};

struct PathSet {
    std::vector<Path> paths;  ///< the most probable first, but for rounding
    Enclosure total;          ///< of their probabilities
    bool enough = false;      ///< the total reaches the bound, in spite of rounding
};

/// As few of the most probable paths as are enough; where `most` of them cannot be, only some. Throws LimitReached.
[[nodiscard]] PathSet probable_paths(const PathsWanted& wanted);

}  // namespace robochart::markov
