// Howard's policy iteration on one component.
#pragma once

#include <functional>
#include <optional>

#include "checker/markov/solve/elimination.hpp"

namespace robochart::markov {

/// What a choice of an unknown is worth if it is taken until another unknown is reached: as accurate as the sum of the
/// probabilities to get there, and better than the value exactly where taking it once is.
template <class Value>
[[nodiscard]] Value worth(const System<Value>& system, std::uint32_t unknown, std::uint32_t choice,
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

/// `improves(value, worth)`: whether a choice of this worth replaces the policy's, of this value. `admitted(choice)`:
/// whether it may. Nothing where the elimination ends without a result.
template <class Value>
[[nodiscard]] std::optional<SystemSolution<Value>> iterate_policies(
    const System<Value>& system, Policy policy, const EliminationLimit& limit,
    const std::function<bool(const Value& value, const Value& worth)>& improves,
    const std::function<bool(std::uint32_t choice)>& admitted, std::uint64_t most_rounds);

}  // namespace robochart::markov
