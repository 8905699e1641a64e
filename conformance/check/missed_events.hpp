// Events that come while nothing can take them, in all states of the code (docs/conformance.md, "Events that can be
// missed").
#pragma once

#include <vector>

#include "conformance/check/result.hpp"
#include "conformance/code/code_system.hpp"
#include "cpp_emit/plan/options.hpp"

namespace robochart::conformance {

/// Where the machines of a controller may miss events, as the generator knows it.
using EventPlaces = std::vector<cpp_emit::EventPlace>;

/// The events of which a register may be raised in vain. `code` has been explored as a whole.
[[nodiscard]] std::vector<MissedEvent> missed_events(const CodeSystem& code, const Alphabet&, const EventPlaces&);

}  // namespace robochart::conformance
