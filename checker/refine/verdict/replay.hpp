// SPDX-License-Identifier: Apache-2.0
// Counterexamples are reported only after a replay. The replay repeats the run step by step and checks the violation
// against a plain powerset of the specification along its trace. The replay is slow and close to the definitions. It
// does not use data of the search. A mismatch is an internal error and throws std::logic_error.
#pragma once

#include "checker/refine/search/budget.hpp"
#include "checker/refine/search/run.hpp"
#include "checker/refine/verdict/findings.hpp"
#include "checker/refine/verdict/verdict.hpp"

namespace robochart::refine {

void confirm_refinement_violation(lts::TransitionSystem& specification, lts::TransitionSystem& implementation, Model,
                                  const Violation&, Budget&);
/// Confirms deadlock, divergence or nondeterminism of one system.
void confirm_property_violation(lts::TransitionSystem&, const Violation&, Budget&);
/// Confirms that the run performs the first events of the trace, and that the system cannot perform all of it.
void confirm_missing_trace(lts::TransitionSystem&, const std::vector<process::Event>& trace, const Run& run, Budget&);
/// Confirms that the run performs exactly the trace.
void confirm_trace(lts::TransitionSystem&, const std::vector<process::Event>& trace, const Run& run, Budget&);

}  // namespace robochart::refine
