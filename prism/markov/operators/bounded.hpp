// SPDX-License-Identifier: Apache-2.0
// Computes probabilities and rewards for a number of steps. Each step is one sweep over the states, so only rounding
// widens the enclosures.
#pragma once

#include <optional>

#include "prism/markov/solve/solution.hpp"

namespace robochart::markov {

/// Computes P [ X set ].
[[nodiscard]] std::vector<Enclosure> next(const Model& model, const StateSet& set, Direction direction,
                                          diagnostics::Budget* budget = nullptr);

/// Computes P [ left U[from,to] right ]. Without `to`, it computes U>=from, up to the requested precision.
[[nodiscard]] Solution bounded_until(const Model& model, const StateSet& left, const StateSet& right,
                                     std::uint64_t from, std::optional<std::uint64_t> to, Direction direction,
                                     const Precision& precision = {});

/// Computes R [ C<=steps ]: the sum of the state rewards of steps 0 .. steps-1 and of the rewards of `steps` choices.
/// Rewards may be negative.
[[nodiscard]] std::vector<Enclosure> cumulative_reward(const Model& model, const Rewards& rewards, std::uint64_t steps,
                                                       Direction direction, diagnostics::Budget* budget = nullptr);

/// Computes R [ I=steps ]: the state reward after `steps` steps. Rewards may be negative.
[[nodiscard]] std::vector<Enclosure> instantaneous_reward(const Model& model, const Rewards& rewards,
                                                          std::uint64_t steps, Direction direction,
                                                          diagnostics::Budget* budget = nullptr);

}  // namespace robochart::markov
