// SPDX-License-Identifier: Apache-2.0
// Implements the operators for a number of steps, with one sweep over the states for each step.
#include <algorithm>

#include "prism/markov/operators/operators.hpp"
#include "prism/markov/solve/arithmetic.hpp"
#include "prism/markov/solve/earnings.hpp"

namespace robochart::markov {
namespace {

template <class Value>
class Sweeps {
public:
    Sweeps(const Model& model, Direction direction, const Precision& precision)
        : model_(model),
          direction_(direction),
          budget_(precision.budget),
          numbers_(convert_numbers(model.numbers, model.exact, Value{})) {}

    /// Returns, for one state, the optimal expectation of these values after one step, plus the reward of the step.
    [[nodiscard]] Value expectation(State state, const std::vector<Value>& values,
                                    const Earnings<Value>& earnings) const {
        const std::uint32_t first = model_.first_choice[state];
        Value result = of_choice(state, first, values, earnings);
        for (std::uint32_t choice = first + 1; choice < model_.first_choice[state + 1]; ++choice)
            result = best_of(result, of_choice(state, choice, values, earnings), direction_);
        return result;
    }

    /// `step(state, values)` computes the value of a state from the values of the previous sweep. Ends early if no
    /// value changes.
    template <class Step>
    void repeat_step(std::uint64_t times, std::vector<Value>& values, Step step) const {
        std::vector<Value> after(values.size());
        for (bool changed = true; changed && times > 0; --times) {
            if (budget_ != nullptr) budget_->check();
            changed = false;
            for (State state = 0; state < model_.states(); ++state) {
                after[state] = step(state, values);
                changed = changed || !(after[state] == values[state]);
            }
            values.swap(after);
        }
    }

private:
    [[nodiscard]] Value of_choice(State state, std::uint32_t choice, const std::vector<Value>& values,
                                  const Earnings<Value>& earnings) const {
        Value sum{};
        if (!earnings.state.empty()) sum += earnings.state[state];
        if (!earnings.choice.empty()) sum += earnings.choice[choice];
        for (std::uint64_t branch = model_.first_branch[choice]; branch < model_.first_branch[choice + 1]; ++branch)
            sum += numbers_[model_.number[branch]] * values[model_.target[branch]];
        return sum;
    }

    const Model& model_;
    const Direction direction_;
    diagnostics::Budget* budget_;
    const std::vector<Value> numbers_;
};

Interval probability(Interval value) {
    value.high = std::min(value.high, 1.0);
    return value;
}

Rational probability(Rational value) {
    return value;
}

template <class Value>
std::vector<Value> indicator(const StateSet& set) {
    std::vector<Value> values(set.size());
    for (State state = 0; state < set.size(); ++state) values[state] = whole_number<Value>(set[state] ? 1 : 0);
    return values;
}

template <class Value>
Result<Value> result_of(std::vector<Value> values) {
    return {std::move(values), {}, {}, {}};
}

}  // namespace

template <class Value>
Result<Value> BoundedOperators<Value>::next(const Model& model, const StateSet& set, Direction direction,
                                            const Precision& precision) {
    const Sweeps<Value> sweeps(model, direction, precision);
    std::vector<Value> values = indicator<Value>(set);
    sweeps.repeat_step(1, values, [&](State state, const std::vector<Value>& before) {
        return probability(sweeps.expectation(state, before, {}));
    });
    return result_of(std::move(values));
}

/// Sweeps from the last step to the first: first for the steps within the interval, then for the `from` steps before
/// it, in which the left side must hold.
template <class Value>
Result<Value> BoundedOperators<Value>::until(const Model& model, const StateSet& left, const StateSet& right,
                                             std::uint64_t from, std::optional<std::uint64_t> to, Direction direction,
                                             const Precision& precision) {
    const Sweeps<Value> sweeps(model, direction, precision);
    const auto on_the_way = [&](State state, const std::vector<Value>& before) {
        return left[state] ? probability(sweeps.expectation(state, before, {})) : Value{};
    };
    Result<Value> result = to ? result_of(indicator<Value>(right))
                              : UnboundedOperators<Value>::until(model, left, right, direction, precision);
    if (to)
        sweeps.repeat_step(*to - from, result.values, [&](State state, const std::vector<Value>& before) {
            return right[state] ? whole_number<Value>(1) : on_the_way(state, before);
        });
    sweeps.repeat_step(from, result.values, on_the_way);
    result.strategy.clear();
    return result;
}

template <class Value>
Result<Value> BoundedOperators<Value>::cumulative_reward(const Model& model, const Rewards& rewards,
                                                         std::uint64_t steps, Direction direction,
                                                         const Precision& precision) {
    const Sweeps<Value> sweeps(model, direction, precision);
    const Earnings<Value> earned = make_earnings<Value>(rewards);
    std::vector<Value> values(model.states());
    sweeps.repeat_step(steps, values, [&](State state, const std::vector<Value>& before) {
        return sweeps.expectation(state, before, earned);
    });
    return result_of(std::move(values));
}

template <class Value>
Result<Value> BoundedOperators<Value>::instantaneous_reward(const Model& model, const Rewards& rewards,
                                                            std::uint64_t steps, Direction direction,
                                                            const Precision& precision) {
    const Sweeps<Value> sweeps(model, direction, precision);
    std::vector<Value> values = make_earnings<Value>(rewards).state;
    values.resize(model.states());
    sweeps.repeat_step(steps, values, [&](State state, const std::vector<Value>& before) {
        return sweeps.expectation(state, before, {});
    });
    return result_of(std::move(values));
}

template struct BoundedOperators<Interval>;
template struct BoundedOperators<Rational>;

}  // namespace robochart::markov
