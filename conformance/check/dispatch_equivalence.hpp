// The event API of generated code against its cycle: both change one state, and an event dispatched must do
// what a cycle with this event does (docs/conformance.md, "One event at a time").
#pragma once

#include "conformance/check/result.hpp"
#include "conformance/code/code_system.hpp"

namespace robochart::conformance {

/// Compares both APIs in all states that `system` has begun a cycle in, with every event and every value of it, and
/// with none; for all answers where the code asks for a choice. Unless the code was found to differ already, a
/// difference is the result: the cycles that lead there, and what both APIs do then. Nothing where no event is
/// received.
void compare_event_api(Result&, const rc_interface&, const CodeSystem& system, const Alphabet&, const refine::Limits&);

}  // namespace robochart::conformance
