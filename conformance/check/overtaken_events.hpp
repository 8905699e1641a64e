// Events of outer transitions that come second where they meet others in one cycle (docs/conformance.md, "Events that
// come second").
#pragma once

#include <vector>

#include "conformance/check/places_in_state.hpp"
#include "conformance/check/result.hpp"
#include "conformance/code/code_system.hpp"

namespace robochart::conformance {

/// In the order of the registers. `code` has been explored as a whole.
[[nodiscard]] std::vector<OvertakenEvent> overtaken_events(const CodeSystem& code, const Alphabet&, const EventPlaces&);

}  // namespace robochart::conformance
