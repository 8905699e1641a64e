// Questions with bounds in models in which bounds count time units (markov::Model::counted), not steps: they are asked
// of the model with the count as a part of its states (markov/operators/layers.hpp). See evaluator.hpp.
#include "checker/markov/operators/layers.hpp"
#include "checker/markov/operators/unbounded.hpp"
#include "checker/prism/evaluator.hpp"

namespace robochart::prism {

/// The right side within the bounds, the left side all the time before.
StateVector Evaluator::timed_until(const StateSet& left, const StateSet& right, const StepBound& steps,
                                   Direction direction) {
    const auto [from, to] = step_range(steps, code_);
    const markov::Layers layers = markov::layers(chain_, to.value_or(from), !to.has_value(), options_.budget);
    StateSet before(layers.model.states());
    StateSet target(layers.model.states());
    for (std::uint64_t count = 0; count <= layers.last; ++count)
        for (markov::State state = 0; state < layers.states; ++state) {
            poll();
            before[layers.at(state, count)] = left[state];
            target[layers.at(state, count)] = right[state] && count >= from;
        }
    StateVector result = options_.exact ? solved(exact_until(layers.model, before, target, direction, options_.budget))
                                        : solved(markov::until(layers.model, before, target, direction, precision()));
    result.numbers.resize(std::min(result.numbers.size(), layers.states));
    result.reals.resize(std::min(result.reals.size(), layers.states));
    return result;
}

/// What is earned until so many time units have passed, the last of them included.
StateVector Evaluator::timed_reward(const markov::Rewards& rewards, std::uint64_t units, Direction direction) {
    if (units == 0) return all_states({Type::real, 0, Real(std::int64_t{0})});
    const markov::Layers layers = markov::layers(chain_, units - 1, false, options_.budget);
    const markov::Rewards earned = markov::in_layers(layers, rewards);
    StateVector result = options_.exact ? solved(exact_total_reward(layers.model, earned, direction, options_.budget))
                                        : solved(total_reward(layers.model, earned, direction, precision()));
    result.numbers.resize(std::min(result.numbers.size(), layers.states));
    result.reals.resize(std::min(result.reals.size(), layers.states));
    return result;
}

}  // namespace robochart::prism
