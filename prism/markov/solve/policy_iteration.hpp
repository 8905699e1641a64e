// SPDX-License-Identifier: Apache-2.0
// Implements Howard's policy iteration on one component.
#pragma once

#include <functional>
#include <optional>

#include "prism/markov/solve/elimination.hpp"

namespace robochart::markov {

/// Returns the value of an unknown if this choice is repeated until another unknown is reached (the worth of the
/// choice). The worth is as accurate as the sum of the probabilities to leave. The worth is better than the current
/// value if and only if taking the choice once is better.
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

/// Runs policy iteration. `improves(value, worth)` decides whether a choice with this worth replaces the policy's
/// choice, whose value is `value`. `admitted(choice)` decides whether the choice may be used. Returns no value if the
/// elimination has no result.
template <class Value>
[[nodiscard]] std::optional<SystemSolution<Value>> iterate_policies(
    const System<Value>& system, Policy policy, const EliminationLimit& limit,
    const std::function<bool(const Value& value, const Value& worth)>& improves,
    const std::function<bool(std::uint32_t choice)>& admitted, std::uint64_t most_rounds);

}  // namespace robochart::markov
