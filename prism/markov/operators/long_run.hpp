// SPDX-License-Identifier: Apache-2.0
// Computes averages over an infinite run of a dtmc, from every state. Both functions throw Unsupported for an mdp.
#pragma once

#include "prism/markov/solve/solution.hpp"

namespace robochart::markov {

/// Computes S [ set ]: the fraction of time spent in the set.
[[nodiscard]] Solution long_run_probability(const Model& model, const StateSet& set, const Precision& precision = {});

/// Computes R [ S ]: the average reward of a step. Rewards may be negative.
[[nodiscard]] Solution long_run_reward(const Model& model, const Rewards& rewards, const Precision& precision = {});

}  // namespace robochart::markov
