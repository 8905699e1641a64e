// SPDX-License-Identifier: Apache-2.0
#include "tests/prism/markov/models/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace robochart::markov {

Description dtmc(const std::vector<std::vector<Branch>>& rows) {
    Description description;
    for (const std::vector<Branch>& row : rows) description.states.push_back({Choice{row, 0}});
    description.left = description.right = StateSet(rows.size(), false);
    return description;
}

Description mdp(std::vector<std::vector<Choice>> states) {
    Description description;
    description.kind = Kind::mdp;
    description.left = description.right = StateSet(states.size(), false);
    description.states = std::move(states);
    return description;
}

StateSet set_of(std::size_t states, const std::vector<State>& members) {
    StateSet set(states, false);
    for (const State member : members) set[member] = true;
    return set;
}

Number enclosing(const Rational& value) {
    const auto near = value.convert_to<double>();
    const Rational back(near);
    if (back == value) return {near, near};
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Number number{back < value ? near : std::nextafter(near, -infinity),
                  back > value ? near : std::nextafter(near, infinity)};
    // The conversion to double may not round to nearest.
    while (Rational(number.low) > value) number.low = std::nextafter(number.low, -infinity);
    while (Rational(number.high) < value) number.high = std::nextafter(number.high, infinity);
    return number;
}

Model model_of(const Description& description) {
    Model model;
    model.kind = description.kind;
    model.initial = {0};
    model.first_choice = {0};
    model.first_branch = {0};
    std::map<Rational, std::uint32_t> numbers;
    for (const std::vector<Choice>& choices : description.states) {
        for (Choice choice : choices) {
            std::ranges::sort(choice.branches, {}, &Branch::target);
            Rational sum = 0;
            for (const Branch& branch : choice.branches) sum += branch.weight;
            for (const Branch& branch : choice.branches) {
                const Rational probability = branch.weight / sum;
                const auto [entry, added] =
                    numbers.try_emplace(probability, static_cast<std::uint32_t>(numbers.size()));
                if (added) {
                    model.exact.push_back(probability);
                    model.numbers.push_back(enclosing(probability));
                }
                model.target.push_back(branch.target);
                model.number.push_back(entry->second);
            }
            model.first_branch.push_back(model.target.size());
        }
        model.first_choice.push_back(static_cast<std::uint32_t>(model.choices()));
    }
    if (model.kind == Kind::mdp) model.action.assign(model.choices(), 0);
    model.actions = {""};
    return model;
}

Rewards rewards_of(const Description& description) {
    Rewards rewards;
    rewards.exact_state = description.rewards;
    for (const Rational& reward : rewards.exact_state) rewards.state.push_back(enclosing(reward));
    for (const std::vector<Choice>& choices : description.states)
        for (const Choice& choice : choices) {
            rewards.exact_choice.push_back(choice.reward);
            rewards.choice.push_back(enclosing(choice.reward));
        }
    return rewards;
}

std::string description_text(const Description& description) {
    std::string result = description.kind == Kind::dtmc ? "dtmc\n" : "mdp\n";
    for (State state = 0; state < description.states.size(); ++state) {
        result += fmt::format("{}{}{}{}:", state, description.left[state] ? " left" : "",
                              description.right[state] ? " right" : "",
                              description.rewards.empty() ? "" : " reward " + description.rewards[state].str());
        for (const Choice& choice : description.states[state]) {
            result += fmt::format("  [{}]", choice.reward.str());
            for (const Branch& branch : choice.branches)
                result += fmt::format(" {}:{}", branch.weight.str(), branch.target);
        }
        result += "\n";
    }
    return result;
}

}  // namespace robochart::markov
