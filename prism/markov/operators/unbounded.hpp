// SPDX-License-Identifier: Apache-2.0
// Computes probabilities and rewards without a step bound, for every state, as enclosures that are valid in spite of
// rounding.
#pragma once

#include "prism/markov/solve/solution.hpp"

namespace robochart::markov {

/// Computes P [ left U right ].
[[nodiscard]] Solution until(const Model& model, const StateSet& left, const StateSet& right, Direction direction,
                             const Precision& precision = {});

/// Computes R [ F target ]: the reward earned before the target is reached. It is infinite if the target is not reached
/// with probability 1 (for the maximum: under every scheduler; for the minimum: under some scheduler). Throws
/// Unsupported if a reward is negative.
[[nodiscard]] Solution reachability_reward(const Model& model, const Rewards& rewards, const StateSet& target,
                                           Direction direction, const Precision& precision = {});

/// Computes R [ C ]: the total reward. Throws Unsupported if a reward is negative.
[[nodiscard]] Solution total_reward(const Model& model, const Rewards& rewards, Direction direction,
                                    const Precision& precision = {});

}  // namespace robochart::markov
