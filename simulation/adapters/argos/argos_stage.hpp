// SPDX-License-Identifier: Apache-2.0
// Runs robots in ARGoS, the simulator of the founding paper's second case study (Li et al. 2017, section 3.2). ARGoS
// has the MIT licence.
#pragma once

#include <string>

#include "simulation/trial/stage.hpp"

namespace robochart::simulation {

/// Makes a stage in which ARGoS moves its own e-pucks (dynamics2d) and reads their light and range-and-bearing sensors.
/// Rays in its physics engine replace the sensors for lines of sight and proximity. Features that ARGoS lacks are
/// rejected (RC-M15). ARGoS is a singleton, so a process can run only one scenario, and one trial at a time.
[[nodiscard]] std::unique_ptr<Stage> argos_stage(const Scenario&, std::uint32_t trial, diagnostics::Diagnostics&);

/// The name under which the adapter's controller is registered with ARGoS, and the first part of the robots' names.
inline constexpr const char* argos_controller = "robochart_stage";
inline constexpr const char* argos_robot = "robot";

/// Returns the experiment in ARGoS' format: the arena with its walls and lights, the robots at their positions in
/// `start`, and the media.
[[nodiscard]] std::string argos_experiment(const Scenario&, const World& start);

}  // namespace robochart::simulation
