// SPDX-License-Identifier: Apache-2.0
// See subgraph.hpp.
#include "prism/assertions/process/subgraph.hpp"

#include <algorithm>
#include <set>
#include <unordered_map>
#include <utility>

namespace robochart::probability {
namespace {

/// A choice in a form that does not depend on the process.
struct SharedChoice {
    std::string action;
    bool tock = false;
    std::vector<std::pair<lts::StateIndex, Rational>> branches;
    friend auto operator<=>(const SharedChoice&, const SharedChoice&) = default;
};

std::set<SharedChoice> choices_of(const DecisionProcess& process, markov::State state) {
    const markov::Model& model = process.model;
    std::set<SharedChoice> result;
    for (std::uint32_t choice = model.first_choice[state]; choice < model.first_choice[state + 1]; ++choice) {
        SharedChoice one{model.actions[model.action[choice]], model.counted[choice], {}};
        for (std::uint64_t branch = model.first_branch[choice]; branch < model.first_branch[choice + 1]; ++branch)
            one.branches.emplace_back(process.origins[model.target[branch]], model.exact[model.number[branch]]);
        std::ranges::sort(one.branches);
        result.insert(std::move(one));
    }
    return result;
}

}  // namespace

bool is_subgraph(const DecisionProcess& fewer, const DecisionProcess& all, diagnostics::Pollable& budget) {
    std::unordered_map<lts::StateIndex, markov::State> state_of;
    for (markov::State state = 0; state < all.origins.size(); ++state)
        if (!state_of.emplace(all.origins[state], state).second) return false;
    const auto same = [&](markov::State state) { return state_of.find(fewer.origins[state]); };
    const auto initial = same(fewer.model.initial.front());
    if (initial == state_of.end() || initial->second != all.model.initial.front()) return false;
    for (markov::State state = 0; state < fewer.origins.size(); ++state) {
        budget.poll();
        const auto there = same(state);
        if (there == state_of.end() || fewer.deadlocks[state] != all.deadlocks[there->second]) return false;
        const std::set<SharedChoice> some = choices_of(fewer, state);
        const std::set<SharedChoice> every = choices_of(all, there->second);
        if (some.empty() || !std::ranges::includes(every, some)) return false;
    }
    return true;
}

}  // namespace robochart::probability
