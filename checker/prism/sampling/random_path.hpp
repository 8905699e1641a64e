// One random path of a dtmc, kept state by state.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "checker/prism/explore/instance.hpp"
#include "diagnostics/budget.hpp"

namespace robochart::prism {

struct RandomPath {
    struct Step {
        std::string action;                ///< "": none
        std::vector<std::string> modules;  ///< that act, by their names
        std::vector<std::int32_t> values;  ///< of the variables behind the step, in the order of the layout
    };
    std::vector<std::int32_t> initial;
    std::vector<Step> steps;
    bool deadlock = false;  ///< nothing is possible at its end
};

/// The path of this number, as samples of that seed follow it: `steps` at most, and to a deadlock. The model is a dtmc
/// with one initial state. Throws Unsampled, EvaluationError, LimitReached.
[[nodiscard]] RandomPath random_path(const Instance& instance, std::uint64_t seed, std::uint64_t number,
                                     std::uint64_t steps, diagnostics::Budget* budget);

}  // namespace robochart::prism
