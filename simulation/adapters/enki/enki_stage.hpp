// SPDX-License-Identifier: Apache-2.0
// Runs robots in Enki, the simulator of the founding paper's first case study (Li et al. 2017, section 3.1). Enki has
// the licence GPL-2+.
#pragma once

#include "simulation/trial/stage.hpp"

namespace robochart::simulation {

/// Makes a stage in which Enki moves the robots and casts the lines of sight. Enki lacks range-and-bearing, light and
/// proximity sensors of the kind that scenarios need, so scenarios with these sensors are rejected (RC-M15). Only one
/// world can exist at a time, because Enki's random numbers are global.
[[nodiscard]] std::unique_ptr<Stage> enki_stage(const Scenario&, std::uint32_t trial, diagnostics::Diagnostics&);

}  // namespace robochart::simulation
