// SPDX-License-Identifier: Apache-2.0
// Translates names of RoboTool's encoding to terms of the model.
#pragma once

#include "prism/assertions/experiments/encoding.hpp"
#include "prism/emit/emission.hpp"

namespace robochart::probability {

/// Includes the current places of machines and composite states, variables, and values of events. Locks, exit stages
/// and contents of buffers are internal to the encoding.
[[nodiscard]] Wording wording_of(const prism_emit::Emission& emission);

}  // namespace robochart::probability
