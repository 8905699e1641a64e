// SPDX-License-Identifier: Apache-2.0
// Describes endless runs. Some rules and claims demand an event without a time limit. An endless run in which this
// event never occurs breaks them.
#pragma once

#include <optional>

#include "checker/lts/transition_system.hpp"
#include "checker/refine/search/limits.hpp"
#include "checker/refine/verdict/verdict.hpp"
#include "claims/sleec/conformance/endless.hpp"

namespace robochart::driver {

/// Returns the run as steps of the terms from which the system was compiled; the repeated steps are its loop. Returns
/// no value if the system has no terms, or if a state represents several terms. Throws process::Interrupted at a limit.
[[nodiscard]] std::optional<refine::Counterexample> endless_counterexample(lts::TransitionSystem& system,
                                                                           const sleec::EndlessRun& run,
                                                                           const refine::Limits& bounds);

}  // namespace robochart::driver
