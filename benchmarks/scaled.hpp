// SPDX-License-Identifier: Apache-2.0
// Makes scenarios with more robots at the same density, for benchmarks of growing size.
#pragma once

#include <cstdint>

#include "simulation/scenario/scenario.hpp"

namespace robochart {

/// Scales arena, walls, lights and placements with the square root of the number of robots; removes bands and pictures.
[[nodiscard]] simulation::Scenario scaled(const simulation::Scenario&, std::uint32_t robots, double duration);

}  // namespace robochart
