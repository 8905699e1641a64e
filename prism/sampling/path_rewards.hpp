// SPDX-License-Identifier: Apache-2.0
// Adds up the reward of a path, item by item of a reward structure.
#pragma once

#include <cstdint>
#include <vector>

#include "prism/checks/checked.hpp"
#include "prism/explore/code.hpp"

namespace robochart::prism {

/// Evaluates rewards. If several items match, their rewards are added.
class PathRewards {
public:
    /// `structure` must outlive the object. Throws EvaluationError.
    PathRewards(const RewardStructure& structure, const std::vector<std::string>& actions, Code& code);

    // Returns the reward of being in a state. This function and the next throw EvaluationError.
    [[nodiscard]] double of_state(StateValues state) const { return sum(of_states_, state); }
    /// Returns the reward of leaving a state with an action.
    [[nodiscard]] double of_step(StateValues state, std::uint32_t action) const {
        return sum(by_action_[action], state);
    }

private:
    struct Item {
        Code::Root guard, value;
        bool fixed;
        double amount;  ///< the reward if it is constant
    };

    [[nodiscard]] double reward_amount(Code::Root value, StateValues state) const;
    [[nodiscard]] double sum(const std::vector<Item>& items, StateValues state) const;

    Code& code_;
    std::vector<Item> of_states_;
    std::vector<std::vector<Item>> by_action_;
};

}  // namespace robochart::prism
