// What follows from a scenario's parts.
#include "simulation/scenario/scenario.hpp"

#include <cmath>

namespace robochart::simulation {

bool Formula::of_trial() const {
    switch (kind) {
        case Kind::compare:
        case Kind::stays:
            return false;
        case Kind::at:
        case Kind::within:
        case Kind::until:
        case Kind::always:
            return true;
        default:
            return parts.front().of_trial();
    }
}

std::uint64_t Scenario::steps() const {
    return static_cast<std::uint64_t>(std::llround(duration / world.control_step));
}

void Scenario::set_robots(std::uint32_t count) {
    robots = count;
    if (arena_area > 0) world.arena.width = world.arena.height = std::sqrt(arena_area * count);
}

}  // namespace robochart::simulation
