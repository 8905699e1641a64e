// SPDX-License-Identifier: Apache-2.0
// What becomes of the platform's events in code that conforms: those that can be missed, those that can be overtaken.
#pragma once

#include "conformance/check/places_in_state.hpp"
#include "conformance/check/result.hpp"
#include "conformance/code/code_system.hpp"

namespace robochart::conformance {

/// Adds them to the result of code that conforms, all of whose states have been explored.
void add_lost_events(Result&, const CodeSystem& code, const Alphabet&, const EventPlaces&);

}  // namespace robochart::conformance
