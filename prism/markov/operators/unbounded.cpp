// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/operators/unbounded.hpp"

#include "prism/markov/operators/answer.hpp"

namespace robochart::markov {

Solution until(const Model& model, const StateSet& left, const StateSet& right, Direction direction,
               const Precision& precision) {
    return solve_precisely(precision, [&](const Precision& working_precision) {
        return UnboundedOperators<Interval>::until(model, left, right, direction, working_precision);
    });
}

Solution reachability_reward(const Model& model, const Rewards& rewards, const StateSet& target, Direction direction,
                             const Precision& precision) {
    return solve_precisely(precision, [&](const Precision& working_precision) {
        return UnboundedOperators<Interval>::reachability_reward(model, rewards, target, direction, working_precision);
    });
}

Solution total_reward(const Model& model, const Rewards& rewards, Direction direction, const Precision& precision) {
    return solve_precisely(precision, [&](const Precision& working_precision) {
        return UnboundedOperators<Interval>::total_reward(model, rewards, direction, working_precision);
    });
}

}  // namespace robochart::markov
