// Rewards as the operators read them.
#pragma once

#include <vector>

#include "checker/markov/model/model.hpp"

namespace robochart::markov {

/// Rewards in another arithmetic; empty vectors: all are 0.
template <class Value>
struct Earnings {
    std::vector<Value> state;
    std::vector<Value> choice;
};

template <class Value>
[[nodiscard]] Earnings<Value> earnings(const Rewards& rewards);

/// Where rewards are above 0. Throws Unsupported where one is negative.
class Payments {
public:
    Payments(const Model& model, const Rewards& rewards);

    /// States that earn something, or may: by one of their choices.
    [[nodiscard]] StateSet states() const;
    /// Of these choices those that earn nothing, their states included.
    [[nodiscard]] std::vector<bool> free_choices(std::vector<bool> choices) const;

private:
    [[nodiscard]] bool pays(State state, std::uint32_t choice) const;

    const Model& model_;
    const Rewards& rewards_;
};

}  // namespace robochart::markov
