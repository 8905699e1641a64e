// SPDX-License-Identifier: Apache-2.0
// Probabilities and rewards without a step bound, for every state, as enclosures that are valid in spite of rounding.
#pragma once

#include "prism/markov/solve/solution.hpp"

namespace robochart::markov {

/// P [ left U right ].
[[nodiscard]] Solution until(const Model& model, const StateSet& left, const StateSet& right, Direction direction,
                             const Precision& precision = {});

/// R [ F target ]: the reward earned before the target is reached; infinite if it is not reached with probability 1
/// (maximum: under every scheduler; minimum: under one). Throws Unsupported if a reward is negative.
[[nodiscard]] Solution reachability_reward(const Model& model, const Rewards& rewards, const StateSet& target,
                                           Direction direction, const Precision& precision = {});

/// R [ C ]: the total reward. Throws Unsupported if a reward is negative.
[[nodiscard]] Solution total_reward(const Model& model, const Rewards& rewards, Direction direction,
                                    const Precision& precision = {});

}  // namespace robochart::markov
