// SPDX-License-Identifier: Apache-2.0
// Finds events that trigger transitions of outer states and come second if other events are raised in the same cycle
// (docs/conformance.md, "Events that come second").
#pragma once

#include <vector>

#include "conformance/check/places_in_state.hpp"
#include "conformance/check/result.hpp"
#include "conformance/code/explored_code.hpp"
#include "conformance/code/interface.hpp"

namespace robochart::conformance {

/// Returns the events in the order of their registers. `code` must have been explored completely.
[[nodiscard]] std::vector<OvertakenEvent> overtaken_events(const ExploredCode& code, const Alphabet&,
                                                           const EventPlaces&);

}  // namespace robochart::conformance
