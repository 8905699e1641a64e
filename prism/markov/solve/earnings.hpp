// SPDX-License-Identifier: Apache-2.0
// Rewards in the form that the operators use.
#pragma once

#include <vector>

#include "prism/markov/model/model.hpp"

namespace robochart::markov {

/// Rewards in another arithmetic; empty vectors: all rewards are 0.
template <class Value>
struct Earnings {
    std::vector<Value> state;
    std::vector<Value> choice;
};

template <class Value>
[[nodiscard]] Earnings<Value> make_earnings(const Rewards& rewards);

/// The places of positive rewards. Throws Unsupported if a reward is negative.
class Payments {
public:
    Payments(const Model& model, const Rewards& rewards);

    /// The states that earn something, or can earn something by one of their choices.
    [[nodiscard]] StateSet states() const;
    /// Returns the given choices that earn nothing and belong to states that earn nothing.
    [[nodiscard]] std::vector<bool> free_choices(std::vector<bool> choices) const;

private:
    [[nodiscard]] bool pays_reward(State state, std::uint32_t choice) const;

    const Model& model_;
    const Rewards& rewards_;
};

}  // namespace robochart::markov
