// SPDX-License-Identifier: Apache-2.0
// Prepares rewards for the operators.
#pragma once

#include <vector>

#include "prism/markov/model/model.hpp"

namespace robochart::markov {

/// The rewards in another arithmetic. An empty vector means that all rewards are 0.
template <class Value>
struct Earnings {
    std::vector<Value> state;
    std::vector<Value> choice;
};

template <class Value>
[[nodiscard]] Earnings<Value> make_earnings(const Rewards& rewards);

/// Finds out where rewards are positive. Throws Unsupported if a reward is negative.
class Payments {
public:
    Payments(const Model& model, const Rewards& rewards);

    /// Returns the states that earn a reward, themselves or by one of their choices.
    [[nodiscard]] StateSet states() const;
    /// Returns the given choices that earn nothing and belong to states that earn nothing.
    [[nodiscard]] std::vector<bool> free_choices(std::vector<bool> choices) const;

private:
    [[nodiscard]] bool pays_reward(State state, std::uint32_t choice) const;

    const Model& model_;
    const Rewards& rewards_;
};

}  // namespace robochart::markov
