// SPDX-License-Identifier: Apache-2.0
// Refinement in the tick-tock model (Baxter, Ribeiro, Cavalcanti, "Sound reasoning in tock-CSP", Acta Informatica
// 2022): refusals are observed before each tock and at the end of an observation. See docs/conformance.md, "Tick-tock".
#pragma once

#include "checker/refine/verdict/check.hpp"

namespace robochart::conformance {

/// specification [TT= implementation, both under maximal progress: tock only if neither τ nor ✓ is possible. The model
/// does not observe divergence, and neither does this check. The two share one EventTable. A counterexample ends with
/// the event that the specification does not have (`trace`; possibly a tock, which it does not have after such
/// refusals), or in a state in which the implementation refuses too much (`refusal`).
[[nodiscard]] refine::Verdict tick_tock_refines(lts::TransitionSystem& specification,
                                                lts::TransitionSystem& implementation, process::Event tock,
                                                const refine::Limits&);

}  // namespace robochart::conformance
