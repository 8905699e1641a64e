// SPDX-License-Identifier: Apache-2.0
// Computes averages over infinite runs of a dtmc. In a bottom component, the average is a quotient: the expected reward
// between two visits of a state, divided by the expected number of steps between them. The probabilities to reach each
// component are computed by equations.
#include "prism/markov/operators/operators.hpp"

#include <algorithm>
#include "prism/markov/solve/arithmetic.hpp"
#include "prism/markov/solve/earnings.hpp"
#include "prism/markov/solve/equations.hpp"

namespace robochart::markov {
namespace {

double positive_part(double value) {
    return std::max(value, 0.0);
}

Interval positive_part(const Interval& value) {
    Interval part;
    part.negated_low = std::min(value.negated_low, 0.0);
    part.high = positive_part(value.high);
    return part;
}

Rational positive_part(const Rational& value) {
    return value > 0 ? value : Rational(0);
}

template <class Value>
std::vector<Value> positive_parts(const std::vector<Value>& values, bool of_the_negated) {
    std::vector<Value> parts;
    parts.reserve(values.size());
    for (const Value& value : values) parts.push_back(positive_part(of_the_negated ? Value(Value{} - value) : value));
    return parts;
}

template <class Value>
class LongRun {
public:
    LongRun(const Model& model, const Precision& precision)
        : graph_(model),
          model_(model),
          precision_(precision),
          numbers_(convert_numbers(model.numbers, model.exact, Value{})) {
        if (model.kind != Kind::dtmc)
            throw Unsupported("long-run averages are supported only for a dtmc, not for an mdp");
    }

    Result<Value> average_earnings(const Earnings<Value>& earnings) {
        const std::vector<std::vector<State>> components = bottom_components(model_);
        const std::vector<Value> earned = between_visits(components, earnings);
        const std::vector<Value> steps =
            between_visits(components, {std::vector<Value>(model_.states(), whole_number<Value>(1)), {}});
        result_.values.assign(model_.states(), Value{});
        StateSet open(model_.states(), true);
        for (std::size_t index = 0; index < components.size(); ++index)
            for (const State state : components[index]) {
                result_.values[state] = earned[index] / steps[index];
                open[state] = false;
            }
        solve_open(std::move(open), {}, result_.values);
        return std::move(result_);
    }

private:
    void solve_open(StateSet open, Earnings<Value> earnings, std::vector<Value>& values) {
        Equations<Value> equations{graph_,
                                   std::move(open),
                                   std::vector<bool>(model_.choices(), true),
                                   {},
                                   std::move(earnings),
                                   std::move(values),
                                   {Direction::maximum, precision_},
                                   false};
        std::vector<std::uint32_t> strategy;
        equations.goal.precision.strategy = false;
        solve(equations, strategy, result_.shortfall);
        values = std::move(equations.values);
    }

    [[nodiscard]] Value earned_in(State state, const Earnings<Value>& earnings) const {
        Value sum{};
        if (!earnings.state.empty()) sum += earnings.state[state];
        if (!earnings.choice.empty()) sum += earnings.choice[state];
        return sum;
    }

    /// Returns, for each component, the expected reward between two visits of its first state.
    std::vector<Value> between_visits(const std::vector<std::vector<State>>& components,
                                      const Earnings<Value>& earnings) {
        StateSet open(model_.states(), false);
        for (const std::vector<State>& component : components)
            for (const State state : component) open[state] = state != component.front();
        std::vector<Value> values(model_.states());
        solve_open(std::move(open), earnings, values);
        std::vector<Value> sums;
        for (const std::vector<State>& component : components) {
            const State first = component.front();
            sums.push_back(earned_in(first, earnings));
            for (std::uint64_t branch = model_.first_branch[first]; branch < model_.first_branch[first + 1]; ++branch)
                sums.back() += numbers_[model_.number[branch]] * values[model_.target[branch]];
        }
        return sums;
    }

    const Graph graph_;
    const Model& model_;
    const Precision& precision_;
    const std::vector<Value> numbers_;
    Result<Value> result_;
};

}  // namespace

template <class Value>
Result<Value> LongRunOperators<Value>::probability(const Model& model, const StateSet& set,
                                                   const Precision& precision) {
    Earnings<Value> earnings;
    for (State state = 0; state < set.size(); ++state)
        earnings.state.push_back(whole_number<Value>(set[state] ? 1 : 0));
    Result<Value> result = LongRun<Value>(model, precision).average_earnings(earnings);
    for (Value& value : result.values) value = best_of(value, whole_number<Value>(1), Direction::minimum);
    return result;
}

template <class Value>
Result<Value> LongRunOperators<Value>::reward(const Model& model, const Rewards& rewards, const Precision& precision) {
    const Earnings<Value> all = make_earnings<Value>(rewards);
    Result<Value> earned = LongRun<Value>(model, precision)
                               .average_earnings({positive_parts(all.state, false), positive_parts(all.choice, false)});
    const bool loses = std::ranges::any_of(rewards.state, [](const Number& number) { return number.low < 0; }) ||
                       std::ranges::any_of(rewards.choice, [](const Number& number) { return number.low < 0; });
    if (!loses) return earned;
    const Result<Value> lost =
        LongRun<Value>(model, precision)
            .average_earnings({positive_parts(all.state, true), positive_parts(all.choice, true)});
    for (State state = 0; state < model.states(); ++state)
        earned.values[state] = earned.values[state] - lost.values[state];
    if (earned.shortfall.empty()) earned.shortfall = lost.shortfall;
    return earned;
}

template struct LongRunOperators<Interval>;
template struct LongRunOperators<Rational>;

}  // namespace robochart::markov
