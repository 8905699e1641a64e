// SPDX-License-Identifier: Apache-2.0
// Reads the ranges of RoboTool's encoding in PRISM from RoboTool's preferences or from the instantiation.
#pragma once

#include <optional>

#include "driver/model/pipeline.hpp"
#include "prism/emit/emission.hpp"

namespace robochart::driver {

/// Returns the ranges of RoboTool's encoding. If they cannot be read, adds a finding and returns no value.
[[nodiscard]] std::optional<prism_emit::Preferences> read_preferences(Project&, const ProbabilitySettings&);

}  // namespace robochart::driver
