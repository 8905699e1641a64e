// SPDX-License-Identifier: Apache-2.0
// The ranges of RoboTool's encoding in PRISM, from its preferences or from the instantiation.
#pragma once

#include <optional>

#include "driver/model/pipeline.hpp"
#include "prism/emit/emission.hpp"

namespace robochart::driver {

/// The ranges of RoboTool's encoding; no value, with a finding, if they cannot be read.
[[nodiscard]] std::optional<prism_emit::Preferences> read_preferences(Project&, const ProbabilitySettings&);

}  // namespace robochart::driver
