// What holds of small models, by definition: dense rational equations for each of all memoryless schedulers. Shares
// nothing with the code that it tests but the numbers.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "checker/markov/solve/solution.hpp"
#include "tests/checker/markov/models/description.hpp"

namespace robochart::markov::naive {

/// Of each state; nothing: infinite.
using Values = std::vector<std::optional<Rational>>;
using Matrix = std::vector<std::vector<Rational>>;
/// The number of the choice that each state takes.
using Scheduler = std::vector<std::size_t>;

[[nodiscard]] std::size_t schedulers(const Description& description);
/// The best value of each state over all memoryless schedulers.
[[nodiscard]] Values best(const Description& description, Direction direction,
                          const std::function<Values(const Scheduler&)>& values);

[[nodiscard]] Values until(const Description& description, const Scheduler& scheduler);
[[nodiscard]] Values until(const Description& description, Direction direction);
/// Before `right` is reached.
[[nodiscard]] Values reachability_reward(const Description& description, const Scheduler& scheduler);
[[nodiscard]] Values reachability_reward(const Description& description, Direction direction);
[[nodiscard]] Values total_reward(const Description& description, const Scheduler& scheduler);
[[nodiscard]] Values total_reward(const Description& description, Direction direction);

/// By the definition along the steps; without `to`, `after` says what holds from step `from` on.
[[nodiscard]] Rational bounded_until(const Description& description, State state, std::uint64_t from, std::uint64_t to,
                                     Direction direction);
[[nodiscard]] Rational cumulative_reward(const Description& description, State state, std::uint64_t steps,
                                         Direction direction);
[[nodiscard]] Rational instantaneous_reward(const Description& description, State state, std::uint64_t steps,
                                            Direction direction);

/// Of a dtmc: the average of the rewards of a step.
[[nodiscard]] Values long_run_reward(const Description& description);

/// Which states each state leads to, in 0 steps or more, under a scheduler.
[[nodiscard]] std::vector<std::vector<bool>> reachability(const Matrix& matrix);
[[nodiscard]] Matrix matrix(const Description& description, const Scheduler& scheduler);

}  // namespace robochart::markov::naive
