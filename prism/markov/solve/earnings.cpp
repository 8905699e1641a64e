// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/solve/earnings.hpp"

#include <algorithm>

#include "prism/markov/solve/arithmetic.hpp"

namespace robochart::markov {
namespace {

bool is_negative(const Number& number) {
    return number.low < 0;
}

}  // namespace

template <class Value>
Earnings<Value> make_earnings(const Rewards& rewards) {
    return {convert_numbers(rewards.state, rewards.exact_state, Value{}),
            convert_numbers(rewards.choice, rewards.exact_choice, Value{})};
}

template Earnings<Interval> make_earnings(const Rewards&);
template Earnings<Rational> make_earnings(const Rewards&);

Payments::Payments(const Model& model, const Rewards& rewards) : model_(model), rewards_(rewards) {
    if (std::ranges::any_of(rewards.state, is_negative) || std::ranges::any_of(rewards.choice, is_negative))
        throw Unsupported("a reward is negative; without a bound on the steps only rewards of 0 or more are supported");
}

bool Payments::pays_reward(State state, std::uint32_t choice) const {
    return (!rewards_.state.empty() && rewards_.state[state].high > 0) ||
           (!rewards_.choice.empty() && rewards_.choice[choice].high > 0);
}

StateSet Payments::states() const {
    StateSet set(model_.states(), false);
    for (State state = 0; state < model_.states(); ++state)
        for (std::uint32_t choice = model_.first_choice[state]; choice < model_.first_choice[state + 1]; ++choice)
            if (pays_reward(state, choice)) set[state] = true;
    return set;
}

std::vector<bool> Payments::free_choices(std::vector<bool> choices) const {
    for (State state = 0; state < model_.states(); ++state)
        for (std::uint32_t choice = model_.first_choice[state]; choice < model_.first_choice[state + 1]; ++choice)
            if (pays_reward(state, choice)) choices[choice] = false;
    return choices;
}

}  // namespace robochart::markov
