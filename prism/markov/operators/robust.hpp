// SPDX-License-Identifier: Apache-2.0
// Computes properties of Markov chains whose probabilities are known only within bounds. In every step, nature chooses
// probabilities within the bounds, independently of other steps. So a statement about all choices of nature holds for
// every chain within the bounds. The method is robust value iteration (Nilim and El Ghaoui, Operations Research 53,
// 2005; Givan, Leach and Dean, Artificial Intelligence 122, 2000).
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

/// The branches of a state, with ascending targets. They represent all vectors of probabilities within the bounds. At
/// least one such vector must exist.
using UncertainRow = std::vector<UncertainBranch>;

/// A chain, with one row for each state.
using UncertainChain = std::vector<UncertainRow>;

/// Bounds, for each state, the probability to reach `goal` within 0, 1, ... `steps` steps. With `minimum`, the result
/// is a lower bound for every chain within the bounds; with `maximum`, an upper bound. Rounding can only loosen the
/// bounds. `result[k][s]` is the bound for k steps from s. Throws std::invalid_argument if a row contains no vector of
/// probabilities.
[[nodiscard]] std::vector<std::vector<double>> reach_bounds(const UncertainChain& chain, const StateSet& goal,
                                                            std::uint64_t steps, Direction direction,
                                                            diagnostics::Budget* budget = nullptr);

/// Bounds, for each state, the expected value of the state that is reached after 0, 1, ... `steps` steps, for every
/// chain within the bounds. `result[k][s]` is the bound for k steps from s.
[[nodiscard]] std::vector<std::vector<double>> value_bounds(const UncertainChain& chain,
                                                            const std::vector<double>& value, std::uint64_t steps,
                                                            Direction direction, diagnostics::Budget* budget = nullptr);

/// Bounds, for each state, the expected sum of the costs of the states before `goal`. Costs are at least 0, and a state
/// without costs has no predecessors. Value iteration approaches a lower bound from below, so every round gives a lower
/// bound. An upper bound is a vector w with cost + E w <= w for all choices of nature (Park induction). The result is
/// infinite if nature can keep the chain from the goal forever, or if no such vector is found in `most_rounds` rounds.
[[nodiscard]] std::vector<double> cost_bounds(const UncertainChain& chain, const StateSet& goal,
                                              const std::vector<double>& cost, Direction direction,
                                              std::uint64_t most_rounds = 100'000,
                                              diagnostics::Budget* budget = nullptr);

/// Bounds the long-run average of the values of the states that the chain visits, from the state `from`. The bound is
/// the greatest (or the least) value[s] + E v - v[s] over the reachable states s, for some vector v. Any vector gives a
/// bound (Puterman, Markov Decision Processes, 1994, theorem 8.5.5).
[[nodiscard]] double average_bound(const UncertainChain& chain, State from, const std::vector<double>& value,
                                   Direction direction, std::uint64_t most_rounds = 10'000,
                                   diagnostics::Budget* budget = nullptr);

}  // namespace robochart::markov
