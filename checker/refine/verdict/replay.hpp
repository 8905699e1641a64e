// SPDX-License-Identifier: Apache-2.0
// Replays counterexamples before they are reported. A replay repeats the run step by step. To check the violation, a
// replay computes the set of specification states after the trace of the run by a plain powerset construction. A replay
// is slow, follows the definitions closely, and uses no data of the search. A mismatch is an internal error and throws
// std::logic_error.
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
/// Confirms that the run performs the first events of the trace, and that the system cannot perform the whole trace.
void confirm_missing_trace(lts::TransitionSystem&, const std::vector<process::Event>& trace, const Run& run, Budget&);
/// Confirms that the run performs exactly the trace.
void confirm_trace(lts::TransitionSystem&, const std::vector<process::Event>& trace, const Run& run, Budget&);

}  // namespace robochart::refine
