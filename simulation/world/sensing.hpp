// SPDX-License-Identifier: Apache-2.0
// Simulates the sensors of robots in the built-in world: a line of sight, the range and bearing of other robots, light
// with shadows, and proximity. The models follow published ones of the e-puck: Li et al. 2017, section 3; ARGoS'
// range-and-bearing and light sensors.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "simulation/world/cells.hpp"
#include "simulation/world/world.hpp"

namespace robochart::simulation {

enum class Seen { nothing, robot, wall };

/// The first object that a ray meets, and its distance from the origin.
struct Sight {
    Seen what = Seen::nothing;
    double distance = 0;
};

/// Another robot, as a sensor hears it: the distance of its centre, and its direction relative to the heading of the
/// sensing robot, in (-pi, pi].
struct Bearing {
    std::uint32_t robot = 0;
    double distance = 0;
    double angle = 0;
};

struct RangeAndBearing {
    double range = 80;      ///< cm between centres
    bool occlusion = true;  ///< a robot hides the robots that are in the same direction and farther away
    double noise = 0;       ///< standard deviation of the distance, cm
    double loss = 0;        ///< fraction of messages that are lost
};

struct LightRing {
    /// The number of sensors, evenly distributed around the body. The first is half a gap to the left of the heading.
    std::uint32_t sensors = 8;
    double leak = 0;  ///< probability that light reaches a sensor through the body, about one half in ARGoS
};

struct ProximityRing {
    std::uint32_t sensors = 8;
    double range = 10;  ///< cm from the body
};

/// Senses the world at the beginning of a control cycle. The sensors use an index of the robots, so the positions must
/// be updated before the readings of a cycle.
class Sensing {
public:
    explicit Sensing(World& world) : world_(world) {}

    /// Makes the radio of a robot fail: it neither sends nor receives messages.
    void silence(std::size_t robot);

    /// Updates the positions of the robots.
    void update_positions();

    /// Returns the first object on a ray from the front of the robot along its heading. If `range` is 0, the ray is
    /// unlimited.
    [[nodiscard]] Sight line_of_sight(std::size_t robot, double range) const;
    /// Returns the robots in range, ascending by number. `within` further limits the distance (as measured, including
    /// noise).
    [[nodiscard]] const std::vector<Bearing>& range_and_bearing(std::size_t robot, const RangeAndBearing&,
                                                                double within);
    /// True if range_and_bearing would not be empty: it tests the same robots in the same order.
    [[nodiscard]] bool somebody_within(std::size_t robot, const RangeAndBearing&, double within);
    /// Returns the number of sensors of the ring that the light reaches. Other robots cast shadows.
    [[nodiscard]] std::uint32_t lit_sensors(std::size_t robot, const LightRing&, Vector light);
    /// Returns the distance from the body to the nearest robot or wall that a sensor of the ring detects; no value if
    /// none is in range.
    [[nodiscard]] std::optional<double> nearest_distance(std::size_t robot, const ProximityRing&) const;

private:
    static constexpr std::uint32_t nobody = 0xffffffffU;

    [[nodiscard]] double first_disk(Vector origin, Vector direction, double range, std::uint32_t self,
                                    std::uint32_t other) const;
    [[nodiscard]] double first_disk_in_cells(Vector origin, Vector direction, double range, std::uint32_t self,
                                             std::uint32_t other) const;
    [[nodiscard]] double first_wall(Vector origin, Vector direction, double range) const;
    [[nodiscard]] Sight cast_ray(Vector origin, Vector direction, double range, std::uint32_t self) const;
    [[nodiscard]] bool is_hidden(Vector from, Vector to, std::uint32_t self, std::uint32_t other) const;
    [[nodiscard]] std::optional<Bearing> hear_robot(std::uint32_t robot, std::uint32_t other, const RangeAndBearing&,
                                                    double within);
    void find_neighbours(std::size_t robot, double reach);

    [[nodiscard]] bool is_silent(std::size_t robot) const { return robot < silent_.size() && silent_[robot]; }

    World& world_;
    std::vector<bool> silent_;  ///< empty while no radio has failed
    Cells cells_;
    bool indexed_ = false;
    std::vector<std::uint32_t> near_;
    std::vector<Bearing> heard_;
};

}  // namespace robochart::simulation
