// SPDX-License-Identifier: Apache-2.0
// Checks refinement in the tick-tock model (Baxter, Ribeiro, Cavalcanti, "Sound reasoning in tock-CSP", Acta
// Informatica 2022). In this model, refusals are observed before each tock and at the end of an observation
// (docs/conformance.md, "Tick-tock").
#pragma once

#include "checker/refine/verdict/check.hpp"

namespace robochart::conformance {

/// Checks specification [TT= implementation. Both systems have maximal progress: tock is possible only if neither τ nor
/// ✓ is possible. The tick-tock model does not observe divergence, so the check ignores divergence. The two systems
/// share one EventTable. A counterexample of kind `trace` ends with an event that the specification does not allow.
/// This event may be a tock that the specification does not allow after the observed refusals. A counterexample of kind
/// `refusal` ends in a state in which the implementation refuses too much.
[[nodiscard]] refine::Verdict tick_tock_refines(lts::TransitionSystem& specification,
                                                lts::TransitionSystem& implementation, process::Event tock,
                                                const refine::Limits&);

}  // namespace robochart::conformance
