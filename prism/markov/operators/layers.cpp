// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/operators/layers.hpp"

#include <algorithm>
#include <limits>

namespace robochart::markov {

Layers layers(const Model& model, std::uint64_t last, bool stays, diagnostics::Budget* budget) {
    constexpr std::uint64_t most = std::numeric_limits<State>::max() / 2;
    Layers result;
    result.states = model.states();
    result.last = last;
    if (last >= most || (last + 1) > most / std::max<std::size_t>(1, std::max(model.states(), model.choices())))
        throw diagnostics::LimitReached("a bound times the states of the model is too large");
    Model& made = result.model;
    made.kind = model.kind;
    made.numbers = model.numbers;
    made.exact = model.exact;
    made.actions = model.actions;
    made.initial = model.initial;
    made.first_choice = {0};
    made.first_branch = {0};
    for (std::uint64_t count = 0; count <= last; ++count)
        for (State state = 0; state < model.states(); ++state) {
            if (budget != nullptr) budget->poll();
            for (std::size_t choice = model.first_choice[state]; choice < model.first_choice[state + 1]; ++choice) {
                const bool counts = model.counted[choice];
                const bool out = counts && count == last && !stays;
                const std::uint64_t next = counts && count < last ? count + 1 : count;
                for (std::uint64_t i = model.first_branch[choice]; i < model.first_branch[choice + 1] && !out; ++i) {
                    made.target.push_back(result.state_in_layer(model.target[i], next));
                    made.number.push_back(model.number[i]);
                }
                if (out) {
                    made.target.push_back(result.first_state_beyond());
                    made.number.push_back(static_cast<std::uint32_t>(made.numbers.size()));
                }
                made.first_branch.push_back(made.target.size());
                if (!model.action.empty()) made.action.push_back(model.action[choice]);
            }
            made.first_choice.push_back(static_cast<std::uint32_t>(made.choices()));
        }
    made.target.push_back(result.first_state_beyond());
    made.number.push_back(static_cast<std::uint32_t>(made.numbers.size()));
    made.first_branch.push_back(made.target.size());
    if (!model.action.empty()) made.action.push_back(0);
    made.first_choice.push_back(static_cast<std::uint32_t>(made.choices()));
    made.numbers.push_back({1, 1});
    if (!made.exact.empty()) made.exact.emplace_back(1);
    return result;
}

Rewards in_layers(const Layers& layers, const Rewards& rewards) {
    Rewards result;
    result.name = rewards.name;
    const auto repeat = [&](const auto& once, auto& all, const auto& zero) {
        if (once.empty()) return;
        for (std::uint64_t count = 0; count <= layers.last; ++count) all.insert(all.end(), once.begin(), once.end());
        all.push_back(zero);
    };
    repeat(rewards.state, result.state, Number{});
    repeat(rewards.choice, result.choice, Number{});
    repeat(rewards.exact_state, result.exact_state, Rational(0));
    repeat(rewards.exact_choice, result.exact_choice, Rational(0));
    return result;
}

}  // namespace robochart::markov
