// SPDX-License-Identifier: Apache-2.0
// Translates names of RoboTool's encoding to names of the RoboChart model.
#pragma once

#include "prism/assertions/experiments/encoding.hpp"
#include "prism/emit/emission.hpp"

namespace robochart::probability {

/// Returns the names for the current places of machines and composite states, for variables, and for values of events.
/// Locks, exit stages and contents of buffers are internal to the encoding and have no names.
[[nodiscard]] Wording wording_of(const prism_emit::Emission& emission);

}  // namespace robochart::probability
