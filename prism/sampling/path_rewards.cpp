// SPDX-License-Identifier: Apache-2.0
// See path_rewards.hpp.
#include "prism/sampling/path_rewards.hpp"

#include <algorithm>

#include "prism/explore/rules.hpp"

namespace robochart::prism {

PathRewards::PathRewards(const RewardStructure& structure, const std::vector<std::string>& actions, Code& code)
    : code_(code), by_action_(actions.size()) {
    for (const RewardItem& item : structure.items) {
        Item coded{code.compile(item.guard), code.compile(item.value), false, 0};
        coded.fixed = code.is_constant(coded.value) &&
                      code.real(coded.value, nullptr).compare(Real(std::int64_t{0})).value_or(0) >= 0;
        if (coded.fixed) coded.amount = reward_amount(coded.value, nullptr);
        if (!item.transition) {
            of_states_.push_back(coded);
            continue;
        }
        const auto found = std::ranges::find(actions, item.action.text);
        if (found != actions.end()) by_action_[static_cast<std::size_t>(found - actions.begin())].push_back(coded);
    }
}

double PathRewards::reward_amount(Code::Root value, StateValues state) const {
    const Real real = code_.real(value, state);
    if (real.compare(Real(std::int64_t{0})) == -1)
        throw EvaluationError(rules::negative_reward, code_.span(value), {real.text()});
    return real.bounds().middle();
}

double PathRewards::sum(const std::vector<Item>& items, StateValues state) const {
    double result = 0;
    for (const Item& item : items)
        if (code_.holds(item.guard, state)) result += item.fixed ? item.amount : reward_amount(item.value, state);
    return result;
}

}  // namespace robochart::prism
