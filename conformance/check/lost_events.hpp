// SPDX-License-Identifier: Apache-2.0
// Finds events that may have no effect although the code conforms: events that can be missed, and events that can come
// second.
#pragma once

#include "conformance/check/places_in_state.hpp"
#include "conformance/check/result.hpp"
#include "conformance/code/explored_code.hpp"
#include "conformance/code/interface.hpp"

namespace robochart::conformance {

/// Adds these events to the result. The code must conform, and all its states must have been explored.
void add_lost_events(Result&, const ExploredCode& code, const Alphabet&, const EventPlaces&);

}  // namespace robochart::conformance
