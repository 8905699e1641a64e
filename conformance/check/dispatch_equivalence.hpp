// SPDX-License-Identifier: Apache-2.0
// Compares the event API of generated code with its cycle API. Both change the same state. To dispatch an event must
// have the same effect as a cycle with only this event (docs/conformance.md, "One event at a time").
#pragma once

#include "conformance/check/result.hpp"
#include "conformance/code/explored_code.hpp"
#include "conformance/code/interface.hpp"

namespace robochart::conformance {

/// Compares both APIs in every state in which `system` has begun a cycle. Tries each event with each of its values, and
/// no event. If the code asks for a choice, tries all answers. If the result contains no difference yet, stores the
/// first one in it: the cycles that lead to it, and what each API does. Does nothing if the component receives no
/// event.
void compare_event_api(Result&, const rc_interface&, const ExploredCode& system, const Alphabet&,
                       const refine::Limits&);

}  // namespace robochart::conformance
