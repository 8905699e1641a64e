// The number of control steps of a scenario.
#include "simulation/scenario/scenario.hpp"

#include <cmath>

namespace robochart::simulation {

std::uint64_t Scenario::steps() const {
    return static_cast<std::uint64_t>(std::llround(duration / world.control_step));
}

}  // namespace robochart::simulation
