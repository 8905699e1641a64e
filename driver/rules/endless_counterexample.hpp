// SPDX-License-Identifier: Apache-2.0
// Describes endless runs. A rule or claim that demands an event without a time limit is broken by a run in which this
// event never occurs.
#pragma once

#include <optional>

#include "checker/lts/transition_system.hpp"
#include "checker/refine/search/limits.hpp"
#include "checker/refine/verdict/verdict.hpp"
#include "claims/sleec/conformance/endless.hpp"

namespace robochart::driver {

/// The run as steps of the terms from which the system was compiled, with the repeated steps as its loop. No value if
/// the system has no terms, or if a state represents several terms. Throws process::Interrupted at a limit.
[[nodiscard]] std::optional<refine::Counterexample> endless_counterexample(lts::TransitionSystem& system,
                                                                           const sleec::EndlessRun& run,
                                                                           const refine::Limits& bounds);

}  // namespace robochart::driver
