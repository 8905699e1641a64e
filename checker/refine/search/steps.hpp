// SPDX-License-Identifier: Apache-2.0
// Lists the transitions of single states for counterexamples and their replay, where speed does not matter.
#pragma once

#include <vector>

#include "checker/refine/search/budget.hpp"
#include "checker/refine/search/run.hpp"
#include "checker/refine/search/stability.hpp"

namespace robochart::refine {

[[nodiscard]] std::vector<lts::Word> initial_of(lts::TransitionSystem& system);
/// Returns every transition of the state, in the order of the system.
[[nodiscard]] std::vector<RunStep> steps_from(lts::TransitionSystem& system, lts::StateView state);
[[nodiscard]] std::vector<RunStep> steps_from(lts::TransitionSystem& system, lts::StateView state, Budget& budget);
/// Returns the offer of a state that has these steps.
[[nodiscard]] Offer offer_of(const std::vector<RunStep>& steps);

}  // namespace robochart::refine
