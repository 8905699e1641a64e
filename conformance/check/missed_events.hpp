// Events that come while nothing can take them, in all states of the code (docs/conformance.md, "Events that can be
// missed").
#pragma once

#include <vector>

#include "conformance/check/places_in_state.hpp"
#include "conformance/check/result.hpp"
#include "conformance/code/code_system.hpp"

namespace robochart::conformance {

/// The events of which a register may be raised in vain. `code` has been explored as a whole.
[[nodiscard]] std::vector<MissedEvent> missed_events(const CodeSystem& code, const Alphabet&, const EventPlaces&);

}  // namespace robochart::conformance
