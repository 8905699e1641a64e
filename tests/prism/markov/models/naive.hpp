// SPDX-License-Identifier: Apache-2.0
// Computes properties of small models by definition: dense rational equations for every memoryless scheduler. Shares
// only the number type with the code under test.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "prism/markov/solve/solution.hpp"
#include "tests/prism/markov/models/description.hpp"

namespace robochart::markov::naive {

/// The value of each state, or nullopt if it is infinite.
using Values = std::vector<std::optional<Rational>>;
using Matrix = std::vector<std::vector<Rational>>;
/// The number of the choice that each state takes.
using Scheduler = std::vector<std::size_t>;

[[nodiscard]] std::size_t schedulers(const Description& description);
/// Returns the best value of each state over all memoryless schedulers.
[[nodiscard]] Values best(const Description& description, Direction direction,
                          const std::function<Values(const Scheduler&)>& values);

[[nodiscard]] Values until(const Description& description, const Scheduler& scheduler);
[[nodiscard]] Values until(const Description& description, Direction direction);
/// Returns the expected reward before `right` is reached.
[[nodiscard]] Values reachability_reward(const Description& description, const Scheduler& scheduler);
[[nodiscard]] Values reachability_reward(const Description& description, Direction direction);
[[nodiscard]] Values total_reward(const Description& description, const Scheduler& scheduler);
[[nodiscard]] Values total_reward(const Description& description, Direction direction);

/// Returns the probability, computed step by step from the definition. Without `to`, `after` contains the values from
/// step `from` on.
[[nodiscard]] Rational bounded_until(const Description& description, State state, std::uint64_t from, std::uint64_t to,
                                     Direction direction);
[[nodiscard]] Rational cumulative_reward(const Description& description, State state, std::uint64_t steps,
                                         Direction direction);
[[nodiscard]] Rational instantaneous_reward(const Description& description, State state, std::uint64_t steps,
                                            Direction direction);

/// Returns the long-run average reward per step of a dtmc.
[[nodiscard]] Values long_run_reward(const Description& description);

/// Returns the states that each state reaches in 0 or more steps.
[[nodiscard]] std::vector<std::vector<bool>> reachability(const Matrix& matrix);
[[nodiscard]] Matrix matrix(const Description& description, const Scheduler& scheduler);

}  // namespace robochart::markov::naive
