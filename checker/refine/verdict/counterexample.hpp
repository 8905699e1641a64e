// SPDX-License-Identifier: Apache-2.0
// Builds counterexamples from runs.
#pragma once

#include "checker/refine/verdict/reference.hpp"
#include "checker/refine/verdict/verdict.hpp"

namespace robochart::refine {

/// Returns the violation with descriptions of its states. The caller fills in `required`.
[[nodiscard]] Counterexample make_counterexample(const Confirmed& confirmed);
/// For nondeterminism: adds the run that accepts the event that the counterexample's run refuses.
void tell_accepting(const Confirmed& accepting, Counterexample& counterexample);

}  // namespace robochart::refine
