// SPDX-License-Identifier: Apache-2.0
// Emits the timed semantics with processes that show facts about states and variables by events. Claims about states
// and variables (claims/) read these events.
//
// Before any other step, a machine performs `shown__.b1.b2...`. The Boolean bi states whether fact i of the machine is
// true. The event stays visible in all components around the machine. If a transition leaves a state and enters it
// again, the events show that the state was left.
#pragma once

#include "csp_emit/base/emission.hpp"
#include "csp_emit/base/shown.hpp"
#include "semantics/ir/instantiation.hpp"

namespace robochart::csp_emit {

/// Returns the timed semantics (emit.hpp) whose machines show these facts.
[[nodiscard]] Emission emit_showing(const ir::System& system, const ir::Instantiation& instantiation,
                                    const Shown& shown, diagnostics::SourceManager& sources,
                                    diagnostics::Diagnostics& diagnostics);

}  // namespace robochart::csp_emit
