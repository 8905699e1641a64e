// SPDX-License-Identifier: Apache-2.0
// A scenario with more robots at the same density, for benchmarks that grow.
#pragma once

#include <cstdint>

#include "simulation/scenario/scenario.hpp"

namespace robochart {

/// Arena, walls, lights and placements stretched with the root of the number of robots; neither bands nor pictures.
[[nodiscard]] simulation::Scenario scaled(const simulation::Scenario&, std::uint32_t robots, double duration);

}  // namespace robochart
