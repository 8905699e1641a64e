// Markov chains whose probabilities are known within bounds only: what every chain within them has in common. Robust
// value iteration (Nilim and El Ghaoui, Operations Research 53, 2005; Givan, Leach and Dean, Artificial Intelligence
// 122, 2000). Nature chooses anew in each step, so what holds of all her choices holds of every chain within the
// bounds.
#pragma once

#include <cstdint>
#include <vector>

#include "checker/markov/model/model.hpp"
#include "checker/markov/solve/solution.hpp"

namespace robochart::markov {

/// Where a state may go to, and with which probability.
struct UncertainBranch {
    State target = 0;
    double low = 0;  ///< 0 <= low <= high <= 1
    double high = 1;
};

/// The branches of a state: all vectors of probabilities within the bounds, and no farther than `radius` from `centre`
/// in the sum of absolute differences. At least one such vector exists.
struct UncertainRow {
    std::vector<UncertainBranch> branches;  ///< targets ascend
    std::vector<double> centre;             ///< of each branch; empty: no such condition
    double radius = 2;
};

/// A chain with a row for each state.
using UncertainChain = std::vector<UncertainRow>;

/// A bound, for each state, on the probability to come into `goal` within 0, 1, ... `steps` steps, for every chain
/// within the bounds: with `minimum` none is below it, with `maximum` none above it; rounding can only loosen it.
/// `result[k][s]` is about k steps from s. Where a row has both kinds of conditions, the ball alone is used.
/// Throws std::invalid_argument where a row holds no vector of probabilities.
[[nodiscard]] std::vector<std::vector<double>> reach_bounds(const UncertainChain& chain, const StateSet& goal,
                                                            std::uint64_t steps, Direction direction,
                                                            diagnostics::Budget* budget = nullptr);

/// A bound, for each state, on the expectation of a value of the state 0, 1, ... `steps` steps later, for every chain
/// within the bounds. `result[k][s]` is about k steps from s.
[[nodiscard]] std::vector<std::vector<double>> value_bounds(const UncertainChain& chain,
                                                            const std::vector<double>& value, std::uint64_t steps,
                                                            Direction direction, diagnostics::Budget* budget = nullptr);

/// A bound, for each state, on the expected sum of what the states before `goal` cost (at least 0; a state that costs
/// nothing is entered from nowhere). A lower bound is reached from below, so every round gives one. An upper bound is a
/// vector w with cost + E w <= w for all choices of nature (Park induction); infinite where she can keep the chain from
/// the goal for ever, and where no such vector was found in `most_rounds` rounds.
[[nodiscard]] std::vector<double> cost_bounds(const UncertainChain& chain, const StateSet& goal,
                                              const std::vector<double>& cost, Direction direction,
                                              std::uint64_t most_rounds = 100'000,
                                              diagnostics::Budget* budget = nullptr);

/// A bound on what a value of the state is on average in the long run from a state: the greatest value[s] + E v - v[s],
/// or the least, over the states that can be reached, of some vector v (any of them gives a bound: Puterman, Markov
/// Decision Processes, 1994, theorem 8.5.5).
[[nodiscard]] double average_bound(const UncertainChain& chain, State from, const std::vector<double>& value,
                                   Direction direction, std::uint64_t most_rounds = 10'000,
                                   diagnostics::Budget* budget = nullptr);

}  // namespace robochart::markov
