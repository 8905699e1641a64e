// SPDX-License-Identifier: Apache-2.0
// Finds events that can arrive while no transition can take them, over all states of the code (docs/conformance.md,
// "Events that can be missed").
#pragma once

#include <vector>

#include "conformance/check/places_in_state.hpp"
#include "conformance/check/result.hpp"
#include "conformance/code/explored_code.hpp"
#include "conformance/code/interface.hpp"

namespace robochart::conformance {

/// Returns the events that may be raised in their register without effect. `code` must have been explored completely.
[[nodiscard]] std::vector<MissedEvent> missed_events(const ExploredCode& code, const Alphabet&, const EventPlaces&);

}  // namespace robochart::conformance
