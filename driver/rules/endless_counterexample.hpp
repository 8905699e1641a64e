// SPDX-License-Identifier: Apache-2.0
// Describes endless runs. Some rules and claims demand an event without a time limit. Such a rule or claim is broken by
// an endless run in which this event never occurs.
#pragma once

#include <optional>

#include "checker/lts/transition_system.hpp"
#include "checker/refine/search/limits.hpp"
#include "checker/refine/verdict/verdict.hpp"
#include "claims/sleec/conformance/endless.hpp"

namespace robochart::driver {

/// Returns the run as steps of the terms from which the system was compiled. The repeated steps are the loop of the
/// result. Returns no value if the system has no terms, or if a state represents several terms. Throws
/// process::Interrupted at a limit.
[[nodiscard]] std::optional<refine::Counterexample> endless_counterexample(lts::TransitionSystem& system,
                                                                           const sleec::EndlessRun& run,
                                                                           const refine::Limits& bounds);

}  // namespace robochart::driver
