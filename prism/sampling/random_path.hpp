// SPDX-License-Identifier: Apache-2.0
// Stores one random path of a dtmc, state by state.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "prism/explore/instance.hpp"

namespace robochart::prism {

struct RandomPath {
    struct Step {
        std::string action;                ///< "": none
        std::vector<std::string> modules;  ///< names of the modules that act
        std::vector<std::int32_t> values;  ///< values of the variables after the step, in the order of the layout
    };
    std::vector<std::int32_t> initial;
    std::vector<Step> steps;
    bool deadlock = false;  ///< true if the last state is a deadlock
};

/// Returns the path that the sample with this seed and number follows. The path has at most `steps` steps and ends at a
/// deadlock. The model must be a dtmc with one initial state. Throws Unsampled, EvaluationError, LimitReached.
[[nodiscard]] RandomPath random_path(const Instance& instance, std::uint64_t seed, std::uint64_t number,
                                     std::uint64_t steps, diagnostics::Budget* budget);

}  // namespace robochart::prism
