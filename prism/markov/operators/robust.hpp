// SPDX-License-Identifier: Apache-2.0
// Properties of Markov chains whose probabilities are known only within bounds. The results hold for all chains within
// the bounds. Robust value iteration (Nilim and El Ghaoui, Operations Research 53, 2005; Givan, Leach and Dean,
// Artificial Intelligence 122, 2000). In every step, nature chooses probabilities within the bounds, independently of
// other steps. So a statement about all choices of nature holds for every chain within the bounds.
#pragma once

#include <cstdint>
#include <vector>

#include "prism/markov/model/model.hpp"
#include "prism/markov/solve/solution.hpp"

namespace robochart::markov {

/// A possible target of a state, with bounds on its probability.
struct UncertainBranch {
    State target = 0;
    double low = 0;  ///< 0 <= low <= high <= 1
    double high = 1;
};

/// The branches of a state, with ascending targets. They stand for all vectors of probabilities within the bounds; at
/// least one such vector exists.
using UncertainRow = std::vector<UncertainBranch>;

/// A chain, with one row for each state.
using UncertainChain = std::vector<UncertainRow>;

/// Bounds, for each state, on the probability to reach `goal` within 0, 1, ... `steps` steps, for every chain within
/// the bounds: with `minimum`, no probability is below; with `maximum`, none is above. Rounding can only loosen the
/// bounds. `result[k][s]` is for k steps from s. Throws std::invalid_argument if a row contains no vector of
/// probabilities.
[[nodiscard]] std::vector<std::vector<double>> reach_bounds(const UncertainChain& chain, const StateSet& goal,
                                                            std::uint64_t steps, Direction direction,
                                                            diagnostics::Budget* budget = nullptr);

/// Bounds, for each state, on the expectation of a value of the state 0, 1, ... `steps` steps later, for every chain
/// within the bounds. `result[k][s]` is for k steps from s.
[[nodiscard]] std::vector<std::vector<double>> value_bounds(const UncertainChain& chain,
                                                            const std::vector<double>& value, std::uint64_t steps,
                                                            Direction direction, diagnostics::Budget* budget = nullptr);

/// Bounds, for each state, on the expected sum of the costs of states before `goal`. Costs are at least 0, and a state
/// without costs has no predecessors. Value iteration approaches a lower bound from below, so every round gives one. An
/// upper bound is a vector w with cost + E w <= w for all choices of nature (Park induction). It is infinite if nature
/// can keep the chain from the goal forever, and if no such vector is found in `most_rounds` rounds.
[[nodiscard]] std::vector<double> cost_bounds(const UncertainChain& chain, const StateSet& goal,
                                              const std::vector<double>& cost, Direction direction,
                                              std::uint64_t most_rounds = 100'000,
                                              diagnostics::Budget* budget = nullptr);

/// A bound on the long-run average of a value of the state, from a state: the greatest value[s] + E v - v[s], or the
/// least, over the reachable states, for some vector v (any vector gives a bound: Puterman, Markov Decision Processes,
/// 1994, theorem 8.5.5).
[[nodiscard]] double average_bound(const UncertainChain& chain, State from, const std::vector<double>& value,
                                   Direction direction, std::uint64_t most_rounds = 10'000,
                                   diagnostics::Budget* budget = nullptr);

}  // namespace robochart::markov
