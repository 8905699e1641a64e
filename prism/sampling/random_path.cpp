// SPDX-License-Identifier: Apache-2.0
// See random_path.hpp.
#include "prism/sampling/random_path.hpp"

#include <optional>

#include "prism/sampling/walk.hpp"

namespace robochart::prism {

RandomPath random_path(const Instance& instance, std::uint64_t seed, std::uint64_t number, std::uint64_t steps,
                       diagnostics::Budget* budget) {
    diagnostics::Diagnostics unused;  // discarded: warnings about commands are the same for every path
    Code code = instance.code();
    const std::size_t variables = instance.layout().fields().size();
    RandomPath result;
    result.initial = sampled_from(instance, code, budget);
    Walk walk(instance, code, result.initial, unused);
    walk.begin(Draws(seed, number));
    while (walk.length() < steps) {
        if (budget != nullptr) budget->poll();
        const std::optional<std::uint32_t> action = walk.choose();
        if (!action) break;
        RandomPath::Step step{walk.actions()[*action], walk.moving_modules(), {}};
        walk.step();
        step.values.assign(walk.state(), walk.state() + variables);
        result.steps.push_back(std::move(step));
    }
    result.deadlock = !walk.choose();
    return result;
}

}  // namespace robochart::prism
