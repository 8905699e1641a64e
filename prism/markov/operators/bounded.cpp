// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/operators/bounded.hpp"

#include <limits>

#include "prism/markov/operators/answer.hpp"

namespace robochart::markov {
namespace {

/// Returns the precision for results that are computed step by step, which need no convergence criterion.
Precision of_steps(diagnostics::Budget* budget) {
    return {.relative = infinity, .budget = budget};
}

}  // namespace

std::vector<Enclosure> next(const Model& model, const StateSet& set, Direction direction, diagnostics::Budget* budget) {
    return solve_precisely(of_steps(budget),
                           [&](const Precision& working_precision) {
                               return BoundedOperators<Interval>::next(model, set, direction, working_precision);
                           })
        .values;
}

Solution bounded_until(const Model& model, const StateSet& left, const StateSet& right, std::uint64_t from,
                       std::optional<std::uint64_t> to, Direction direction, const Precision& precision) {
    return solve_precisely(to ? of_steps(precision.budget) : precision, [&](const Precision& working_precision) {
        return BoundedOperators<Interval>::until(model, left, right, from, to, direction, working_precision);
    });
}

std::vector<Enclosure> cumulative_reward(const Model& model, const Rewards& rewards, std::uint64_t steps,
                                         Direction direction, diagnostics::Budget* budget) {
    return solve_precisely(of_steps(budget),
                           [&](const Precision& working_precision) {
                               return BoundedOperators<Interval>::cumulative_reward(model, rewards, steps, direction,
                                                                                    working_precision);
                           })
        .values;
}

std::vector<Enclosure> instantaneous_reward(const Model& model, const Rewards& rewards, std::uint64_t steps,
                                            Direction direction, diagnostics::Budget* budget) {
    return solve_precisely(of_steps(budget),
                           [&](const Precision& working_precision) {
                               return BoundedOperators<Interval>::instantaneous_reward(model, rewards, steps, direction,
                                                                                       working_precision);
                           })
        .values;
}

}  // namespace robochart::markov
