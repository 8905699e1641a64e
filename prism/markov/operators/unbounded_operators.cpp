// SPDX-License-Identifier: Apache-2.0
// Implements until, reachability_reward and total_reward. The graph decides where the result is 0, 1 or infinite;
// equations give the other values.
#include "prism/markov/graph/qualitative.hpp"

#include <algorithm>
#include "prism/markov/operators/operators.hpp"
#include "prism/markov/solve/arithmetic.hpp"
#include "prism/markov/solve/earnings.hpp"
#include "prism/markov/solve/equations.hpp"
#include "prism/markov/solve/strategy.hpp"

namespace robochart::markov {
namespace {

/// Returns the states that satisfy a predicate.
template <class Holds>
StateSet states_where(std::size_t states, Holds holds) {
    StateSet set(states);
    for (State state = 0; state < states; ++state) set[state] = holds(state);
    return set;
}

std::vector<bool> every_choice(const Graph& graph) {
    return std::vector<bool>(graph.model().choices(), true);
}

StateSet every_state(const Graph& graph) {
    return StateSet(graph.states(), true);
}

template <class Value>
class Unbounded {
public:
    Unbounded(const Model& model, Direction direction, const Precision& precision)
        : graph_(model),
          model_(model),
          direction_(model.kind == Kind::dtmc ? Direction::maximum : direction),
          precision_(precision),
          strategy_(graph_, precision, result_.strategy) {
        result_.values.assign(model.states(), Value{});
    }

    Result<Value> until(const StateSet& left, const StateSet& right) {
        const bool greatest = direction_ == Direction::maximum;
        const StateSet zero = greatest ? prob0a(graph_, left, right) : prob0e(graph_, left, right);
        const StateSet one = greatest ? prob1e(graph_, left, right) : prob1a(graph_, left, right);
        for (State state = 0; state < model_.states(); ++state)
            if (one[state]) result_.values[state] = whole_number<Value>(1);
        StateSet open = states_where(model_.states(), [&](State state) { return !zero[state] && !one[state]; });
        if (greatest)
            strategy_.reach_goal(right, one, every_choice(graph_));
        else
            strategy_.stay_in_set(zero);
        std::vector<EndComponent> collapsed;
        if (greatest && model_.kind == Kind::mdp) collapsed = end_components(graph_, {open, every_choice(graph_)});
        return solve_equations({graph_,
                                std::move(open),
                                every_choice(graph_),
                                std::move(collapsed),
                                {},
                                {},
                                {direction_, precision_},
                                true});
    }

    Result<Value> reachability_reward(const Rewards& rewards, const StateSet& target) {
        const Payments payments(model_, rewards);
        const bool greatest = direction_ == Direction::maximum;
        const StateSet finite =
            greatest ? prob1a(graph_, every_state(graph_), target) : prob1e(graph_, every_state(graph_), target);
        std::vector<bool> admitted = choices_within(model_, finite);
        if (greatest) {
            const StateSet before = states_where(model_.states(), [&](State state) { return !target[state]; });
            const StateSet never = prob0e(graph_, every_state(graph_), target);
            strategy_.may_reach(never, before);
            strategy_.stay_in_set(never);
            StateSet pays = payments.states();
            for (State state = 0; state < model_.states(); ++state) pays[state] = pays[state] && before[state];
            return expected_earnings(rewards, finite, std::move(admitted), prob0a(graph_, before, pays), {});
        }
        const std::vector<bool> free = payments.free_choices(admitted);
        const StateSet zero = prob1e(graph_, every_state(graph_), target, free);
        strategy_.reach_goal(target, finite, admitted);
        strategy_.reach_goal(target, zero, free);
        const StateSet rest = states_where(model_.states(), [&](State state) { return finite[state] && !zero[state]; });
        std::vector<EndComponent> collapsed = end_components(graph_, {rest, free});
        return expected_earnings(rewards, finite, std::move(admitted), zero, std::move(collapsed));
    }

    /// Computes the total reward. If the maximum is finite, staying in an end component earns nothing, so a scheduler
    /// leaves it only to earn more.
    Result<Value> total_reward(const Rewards& rewards) {
        const Payments payments(model_, rewards);
        const std::vector<bool> free = payments.free_choices(every_choice(graph_));
        if (direction_ == Direction::minimum) return cheapest_rest(rewards, free);
        const StateSet endless = endless_pay(free);
        StateSet finite = exists_finally(graph_, endless);
        finite.flip();
        const StateSet zero = prob0a(graph_, every_state(graph_), payments.states());
        const StateSet rest = states_where(model_.states(), [&](State state) { return finite[state] && !zero[state]; });
        std::vector<EndComponent> collapsed = end_components(graph_, {rest, every_choice(graph_)});
        return expected_earnings(rewards, finite, every_choice(graph_), zero, std::move(collapsed));
    }

private:
    /// Returns the states in which a scheduler can stay and earn a reward infinitely often.
    StateSet endless_pay(const std::vector<bool>& free) {
        StateSet endless(model_.states(), false);
        std::vector<std::pair<EndComponent, std::uint32_t>> paying;
        for (EndComponent& component : end_components(graph_)) {
            const auto paid =
                std::ranges::find_if(component.choices, [&](std::uint32_t choice) { return !free[choice]; });
            if (paid == component.choices.end()) continue;
            for (const State state : component.states) endless[state] = true;
            paying.emplace_back(std::move(component), *paid);
        }
        strategy_.may_reach(endless, every_state(graph_));
        for (const auto& [component, choice] : paying) strategy_.repeat_choice(component, choice);
        return endless;
    }

    /// Returns the least reward on the way to states in which a scheduler can stay without a reward.
    Result<Value> cheapest_rest(const Rewards& rewards, const std::vector<bool>& free) {
        StateSet resting(model_.states(), false);
        const std::vector<EndComponent> components = end_components(graph_, {every_state(graph_), free});
        for (const EndComponent& component : components)
            for (const State state : component.states) resting[state] = true;
        Result<Value> result = reachability_reward(rewards, resting);
        if (precision_.strategy)
            for (const EndComponent& component : components)
                for (const std::uint32_t choice : component.choices) result.strategy[graph_.source(choice)] = choice;
        return result;
    }

    /// Returns the values of the states in `finite`; they are 0 in `zero`.
    Result<Value> expected_earnings(const Rewards& rewards, const StateSet& finite, std::vector<bool> admitted,
                                    const StateSet& zero, std::vector<EndComponent> collapsed) {
        result_.infinite = finite;
        result_.infinite.flip();
        StateSet open = states_where(model_.states(), [&](State state) { return finite[state] && !zero[state]; });
        return solve_equations({graph_,
                                std::move(open),
                                std::move(admitted),
                                std::move(collapsed),
                                make_earnings<Value>(rewards),
                                {},
                                {direction_, precision_},
                                false});
    }

    Result<Value> solve_equations(Equations<Value> equations) {
        equations.values = std::move(result_.values);
        solve(equations, result_.strategy, result_.shortfall);
        result_.values = std::move(equations.values);
        return std::move(result_);
    }

    const Graph graph_;
    const Model& model_;
    const Direction direction_;
    const Precision& precision_;
    Result<Value> result_;
    GraphStrategy strategy_;
};

}  // namespace

template <class Value>
Result<Value> UnboundedOperators<Value>::until(const Model& model, const StateSet& left, const StateSet& right,
                                               Direction direction, const Precision& precision) {
    return Unbounded<Value>(model, direction, precision).until(left, right);
}

template <class Value>
Result<Value> UnboundedOperators<Value>::reachability_reward(const Model& model, const Rewards& rewards,
                                                             const StateSet& target, Direction direction,
                                                             const Precision& precision) {
    return Unbounded<Value>(model, direction, precision).reachability_reward(rewards, target);
}

template <class Value>
Result<Value> UnboundedOperators<Value>::total_reward(const Model& model, const Rewards& rewards, Direction direction,
                                                      const Precision& precision) {
    return Unbounded<Value>(model, direction, precision).total_reward(rewards);
}

template struct UnboundedOperators<Interval>;
template struct UnboundedOperators<Rational>;

}  // namespace robochart::markov
