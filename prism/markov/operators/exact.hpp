// SPDX-License-Identifier: Apache-2.0
// Computes the operators of unbounded.hpp, bounded.hpp and long_run.hpp with rational numbers. The models must be
// small, and need Model::exact, Rewards::exact_state and exact_choice. Time and memory grow with the digits of the
// numbers. The budget, which may be null, limits them.
#pragma once

#include <optional>

#include "prism/markov/solve/solution.hpp"

namespace robochart::markov {

/// The value of every state, or no value if it is infinite.
struct ExactSolution {
    std::vector<std::optional<Rational>> values;
    std::vector<std::uint32_t> strategy;  ///< choices as in Solution::strategy; only for the unbounded operators
};

[[nodiscard]] ExactSolution exact_until(const Model& model, const StateSet& left, const StateSet& right,
                                        Direction direction, diagnostics::Budget* budget = nullptr);
[[nodiscard]] ExactSolution exact_reachability_reward(const Model& model, const Rewards& rewards,
                                                      const StateSet& target, Direction direction,
                                                      diagnostics::Budget* budget = nullptr);
[[nodiscard]] ExactSolution exact_total_reward(const Model& model, const Rewards& rewards, Direction direction,
                                               diagnostics::Budget* budget = nullptr);

[[nodiscard]] ExactSolution exact_next(const Model& model, const StateSet& set, Direction direction,
                                       diagnostics::Budget* budget = nullptr);
[[nodiscard]] ExactSolution exact_bounded_until(const Model& model, const StateSet& left, const StateSet& right,
                                                std::uint64_t from, std::optional<std::uint64_t> to,
                                                Direction direction, diagnostics::Budget* budget = nullptr);
[[nodiscard]] ExactSolution exact_cumulative_reward(const Model& model, const Rewards& rewards, std::uint64_t steps,
                                                    Direction direction, diagnostics::Budget* budget = nullptr);
[[nodiscard]] ExactSolution exact_instantaneous_reward(const Model& model, const Rewards& rewards, std::uint64_t steps,
                                                       Direction direction, diagnostics::Budget* budget = nullptr);

[[nodiscard]] ExactSolution exact_long_run_probability(const Model& model, const StateSet& set,
                                                       diagnostics::Budget* budget = nullptr);
[[nodiscard]] ExactSolution exact_long_run_reward(const Model& model, const Rewards& rewards,
                                                  diagnostics::Budget* budget = nullptr);

}  // namespace robochart::markov
