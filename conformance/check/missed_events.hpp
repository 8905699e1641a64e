// SPDX-License-Identifier: Apache-2.0
// Finds events that can arrive when no transition can take them. Considers all states of the code (docs/conformance.md,
// "Events that can be missed").
#pragma once

#include <vector>

#include "conformance/check/places_in_state.hpp"
#include "conformance/check/result.hpp"
#include "conformance/code/explored_code.hpp"
#include "conformance/code/interface.hpp"

namespace robochart::conformance {

/// Returns the events that may be in their register without any effect. All states of `code` must have been explored.
[[nodiscard]] std::vector<MissedEvent> missed_events(const ExploredCode& code, const Alphabet&, const EventPlaces&);

}  // namespace robochart::conformance
