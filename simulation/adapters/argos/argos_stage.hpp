// Robots in ARGoS, the simulator of the founding paper's second case study (Li et al. 2017, section 3.2). ARGoS is
// under the MIT licence.
#pragma once

#include <string>

#include "simulation/trial/stage.hpp"

namespace robochart::simulation {

/// ARGoS moves its own e-pucks (dynamics2d) and reads its light and range-and-bearing sensors; lines of sight and what
/// is close are asked of its physics by rays. What it lacks is refused (RC-M15). It is a singleton: one scenario a
/// process, one trial at a time.
[[nodiscard]] std::unique_ptr<Stage> argos_stage(const Scenario&, std::uint32_t trial, diagnostics::Diagnostics&);

/// The name under which the adapter's controller is registered with ARGoS, and the first part of the robots' names.
inline constexpr const char* argos_controller = "robochart_stage";
inline constexpr const char* argos_robot = "robot";

/// The experiment as ARGoS reads it: the arena with its walls and lights, robots at the places of `start`, media.
[[nodiscard]] std::string argos_experiment(const Scenario&, const World& start);

}  // namespace robochart::simulation
