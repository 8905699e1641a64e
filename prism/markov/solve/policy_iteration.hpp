// SPDX-License-Identifier: Apache-2.0
// Howard's policy iteration on one component.
#pragma once

#include <functional>
#include <optional>

#include "prism/markov/solve/elimination.hpp"

namespace robochart::markov {

/// Returns the worth of a choice if it is repeated until another unknown is reached. The result is as accurate as the
/// sum of the probabilities to leave. It is better than the value if and only if taking the choice once is better.
template <class Value>
[[nodiscard]] Value value_of_choice(const System<Value>& system, std::uint32_t unknown, std::uint32_t choice,
                                    const std::vector<Value>& values) {
    Value sum = system.constant[choice];
    Value leaving = system.outside[choice];
    for (std::uint64_t entry = system.first_entry[choice]; entry < system.first_entry[choice + 1]; ++entry) {
        if (system.unknown[entry] == unknown) continue;
        const Value& factor = system.numbers[system.number[entry]];
        sum += factor * values[system.unknown[entry]];
        leaving += factor;
    }
    return sum / leaving;
}

/// `improves(value, worth)` tells whether a choice with this worth replaces the policy's choice, whose value is
/// `value`. `admitted(choice)` tells whether the choice may be used. Returns no value if the elimination has no result.
template <class Value>
[[nodiscard]] std::optional<SystemSolution<Value>> iterate_policies(
    const System<Value>& system, Policy policy, const EliminationLimit& limit,
    const std::function<bool(const Value& value, const Value& worth)>& improves,
    const std::function<bool(std::uint32_t choice)>& admitted, std::uint64_t most_rounds);

}  // namespace robochart::markov
