// SPDX-License-Identifier: Apache-2.0
// Builds counterexamples from runs.
#pragma once

#include "checker/refine/verdict/reference.hpp"
#include "checker/refine/verdict/verdict.hpp"

namespace robochart::refine {

/// Returns the counterexample for a violation, with descriptions of its states. The caller must fill in `required`.
[[nodiscard]] Counterexample make_counterexample(const Confirmed& confirmed);
/// Adds a second run to a counterexample of determinism. The second run accepts the event that the first run refuses.
void tell_accepting(const Confirmed& accepting, Counterexample& counterexample);

}  // namespace robochart::refine
