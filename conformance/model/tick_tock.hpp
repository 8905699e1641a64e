// Refinement in the tick-tock model (Baxter, Ribeiro, Cavalcanti, "Sound reasoning in tock-CSP", Acta Informatica
// 2022): what a process refuses is seen before each tock and where an observation ends. Docs: conformance.md,
// "Tick-tock".
#pragma once

#include "checker/refine/verdict/check.hpp"

namespace robochart::conformance {

/// specification [TT= implementation, both under maximal progress: tock only where neither τ nor ✓ is possible. Says
/// nothing of divergence, as the model does not. The two share one EventTable. A counterexample ends with the event
/// that the specification has not (`trace`, a tock among them: it has none behind refusals like these), or where the
/// implementation refuses too much (`refusal`).
[[nodiscard]] refine::Verdict tick_tock_refines(lts::TransitionSystem& specification,
                                                lts::TransitionSystem& implementation, process::Event tock,
                                                const refine::Limits&);

}  // namespace robochart::conformance
