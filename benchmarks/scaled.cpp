// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/scaled.hpp"

#include <cmath>

namespace robochart {

simulation::Scenario scaled(const simulation::Scenario& scenario, std::uint32_t robots, double duration) {
    simulation::Scenario other = scenario;
    const double scale = std::sqrt(static_cast<double>(robots) / scenario.robots);
    other.robots = robots;
    other.duration = duration;
    other.world.arena.width *= scale;
    other.world.arena.height *= scale;
    for (simulation::Segment& wall : other.world.arena.walls) wall = {scale * wall.from, scale * wall.to};
    for (simulation::Light& light : other.lights) light.at = scale * light.at;
    for (simulation::Placement& placement : other.placements) {
        if (placement.kind != simulation::Placement::Kind::region) continue;
        placement.region = {scale * placement.region.low, scale * placement.region.high};
    }
    other.bands.clear();
    other.pictures.clear();
    return other;
}

}  // namespace robochart
