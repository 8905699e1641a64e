// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/operators/long_run.hpp"

#include "prism/markov/operators/answer.hpp"

namespace robochart::markov {

Solution long_run_probability(const Model& model, const StateSet& set, const Precision& precision) {
    return solve_precisely(precision, [&](const Precision& working_precision) {
        return LongRunOperators<Interval>::probability(model, set, working_precision);
    });
}

Solution long_run_reward(const Model& model, const Rewards& rewards, const Precision& precision) {
    return solve_precisely(precision, [&](const Precision& working_precision) {
        return LongRunOperators<Interval>::reward(model, rewards, working_precision);
    });
}

}  // namespace robochart::markov
