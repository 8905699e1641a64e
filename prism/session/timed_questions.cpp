// SPDX-License-Identifier: Apache-2.0
// Evaluates queries with bounds in models whose bounds count time units (markov::Model::counted), not steps. The states
// of the evaluated model include the count (markov/operators/layers.hpp). See evaluator.hpp.
#include <fmt/format.h>

#include <algorithm>

#include "prism/markov/operators/layers.hpp"
#include "prism/markov/operators/unbounded.hpp"
#include "prism/session/evaluator.hpp"

namespace robochart::prism {

/// Returns the probability that the right side holds within the bounds, and the left side at all times before.
StateVector Evaluator::timed_until(const StateSet& left, const StateSet& right, const StepBound& steps,
                                   Direction direction) {
    constexpr std::uint64_t most_states = 200'000'000;  // in all layers together
    const StepRange range = step_range(steps, code_);
    const bool upper = range.to && range.from == 0 && !options_.exact;
    if (upper && *range.to > most_states / std::max<std::size_t>(1, chain_.states()))
        return long_until(left, right, direction);
    return layered_until(left, right, range, direction);
}

StateVector Evaluator::layered_until(const StateSet& left, const StateSet& right, const StepRange& range,
                                     Direction direction) {
    const markov::Layers layers =
        markov::layers(chain_, range.to.value_or(range.from), !range.to.has_value(), options_.budget);
    StateSet before(layers.model.states());
    StateSet target(layers.model.states());
    for (std::uint64_t count = 0; count <= layers.last; ++count)
        for (markov::State state = 0; state < layers.states; ++state) {
            poll();
            before[layers.state_in_layer(state, count)] = left[state];
            target[layers.state_in_layer(state, count)] = right[state] && count >= range.from;
        }
    StateVector result = options_.exact
                             ? to_state_vector(exact_until(layers.model, before, target, direction, options_.budget))
                             : to_state_vector(markov::until(layers.model, before, target, direction, precision()));
    result.numbers.resize(std::min(result.numbers.size(), layers.states));
    result.reals.resize(std::min(result.reals.size(), layers.states));
    return result;
}

/// Handles bounds with too many units to unfold. For every scheduler, the value is at least that for fewer units, and
/// at most that without a bound.
StateVector Evaluator::long_until(const StateSet& left, const StateSet& right, Direction direction) {
    constexpr std::uint64_t few_states = 2'000'000;  // in all layers together
    const std::uint64_t units = std::max<std::uint64_t>(1, few_states / std::max<std::size_t>(1, chain_.states()));
    StateVector result = layered_until(left, right, {0, units}, direction);
    const StateVector ever = to_state_vector(markov::until(chain_, left, right, direction, precision()));
    result.reason.clear();
    for (std::size_t state = 0; state < result.numbers.size(); ++state) {
        Enclosure& value = result.numbers[state];
        value.high = std::max(value.low, ever.numbers[state].high);
        if (value.relative_width() > options_.relative)
            result.reason = fmt::format("time was counted only up to {} units", units);
    }
    return result;
}

/// Returns the reward earned until the given number of time units has passed, including the last unit.
StateVector Evaluator::timed_reward(const markov::Rewards& rewards, std::uint64_t units, Direction direction) {
    if (units == 0) return all_states({Type::real, 0, Real(std::int64_t{0})});
    const markov::Layers layers = markov::layers(chain_, units - 1, false, options_.budget);
    const markov::Rewards earned = markov::in_layers(layers, rewards);
    StateVector result = options_.exact
                             ? to_state_vector(exact_total_reward(layers.model, earned, direction, options_.budget))
                             : to_state_vector(total_reward(layers.model, earned, direction, precision()));
    result.numbers.resize(std::min(result.numbers.size(), layers.states));
    result.reals.resize(std::min(result.reals.size(), layers.states));
    return result;
}

}  // namespace robochart::prism
