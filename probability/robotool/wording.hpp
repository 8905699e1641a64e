// What the names of RoboTool's encoding say to a reader of the model.
#pragma once

#include "prism_emit/emission.hpp"
#include "probability/experiments/encoding.hpp"

namespace robochart::probability {

/// Places of machines and of composite states, variables, values of events. Locks, stages of exits, and what buffers
/// hold serve the encoding.
[[nodiscard]] Wording wording_of(const prism_emit::Emission& emission);

}  // namespace robochart::probability
