// SPDX-License-Identifier: Apache-2.0
// Compares the event API of generated code with its cycle. Both change the same state, and a dispatched event must have
// the effect of a cycle with this event (docs/conformance.md, "One event at a time").
#pragma once

#include "conformance/check/result.hpp"
#include "conformance/code/explored_code.hpp"
#include "conformance/code/interface.hpp"

namespace robochart::conformance {

/// Compares both APIs in every state in which `system` has begun a cycle. Tries every event with each of its values,
/// and no event. If the code asks for a choice, tries all answers. If no difference of the code is known yet, a
/// difference becomes the result: the cycles that lead there, and the behaviour of both APIs. Does nothing if the
/// component receives no event.
void compare_event_api(Result&, const rc_interface&, const ExploredCode& system, const Alphabet&,
                       const refine::Limits&);

}  // namespace robochart::conformance
