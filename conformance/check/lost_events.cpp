// SPDX-License-Identifier: Apache-2.0
#include "conformance/check/lost_events.hpp"

#include "conformance/check/missed_events.hpp"
#include "conformance/check/overtaken_events.hpp"

namespace robochart::conformance {

void add_lost_events(Result& result, const ExploredCode& code, const Alphabet& alphabet, const EventPlaces& places) {
    if (result.outcome != Outcome::conforms) return;
    result.missed = missed_events(code, alphabet, places);
    result.overtaken = overtaken_events(code, alphabet, places);
}

}  // namespace robochart::conformance
