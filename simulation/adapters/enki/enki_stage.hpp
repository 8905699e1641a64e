// Robots in Enki, the simulator of the founding paper's first case study (Li et al. 2017, section 3.1). Enki is GPL-2+.
#pragma once

#include "simulation/trial/stage.hpp"

namespace robochart::simulation {

/// Enki moves the robots and casts the lines of sight. It has no range-and-bearing, light or proximity rings of ours:
/// scenarios with these are refused (RC-M15). One world at a time: its random numbers are global.
[[nodiscard]] std::unique_ptr<Stage> enki_stage(const Scenario&, std::uint32_t trial, diagnostics::Diagnostics&);

}  // namespace robochart::simulation
