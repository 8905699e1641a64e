// What robots perceive in a world: a line of sight, the range and bearing of others, light with shadows, and what is
// close. Models of shared knowledge about the e-puck: Li et al. 2017, section 3; ARGoS' range-and-bearing and light.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "simulation/world/cells.hpp"
#include "simulation/world/world.hpp"

namespace robochart::simulation {

enum class Seen { nothing, robot, wall };

/// What a ray meets first, and how far from its origin.
struct Sight {
    Seen what = Seen::nothing;
    double distance = 0;
};

/// Another robot: how far its centre is, and in which direction from the own heading, in (-pi, pi].
struct Bearing {
    std::uint32_t robot = 0;
    double distance = 0;
    double angle = 0;
};

struct RangeAndBearing {
    double range = 80;      ///< cm between centres
    bool occlusion = true;  ///< a robot in between hides the ones behind it
    double noise = 0;       ///< deviation of the distance, cm
    double loss = 0;        ///< share of messages that do not arrive
};

struct LightRing {
    std::uint32_t sensors = 8;  ///< evenly around the body, the first half a gap left of the heading
    double leak = 0;  ///< how often a sensor that is turned away is lit through its own body, about half in ARGoS
};

struct ProximityRing {
    std::uint32_t sensors = 8;
    double range = 10;  ///< cm from the body
};

/// Looks at a world as it stands at the beginning of a control cycle. Holds an index of the robots, so `update` comes
/// before the looks of a cycle.
class Sensing {
public:
    explicit Sensing(World& world) : world_(world) {}

    /// The radio of a robot fails: it hears nobody, and nobody hears it.
    void silence(std::size_t robot);

    /// Takes in where the robots are now.
    void update();

    /// The first thing on a ray from the front of the robot along its heading; unlimited for `range` 0.
    [[nodiscard]] Sight line_of_sight(std::size_t robot, double range) const;
    /// Robots in reach, ascending by number. `within` limits the distance further (as measured, noise included).
    [[nodiscard]] const std::vector<Bearing>& range_and_bearing(std::size_t robot, const RangeAndBearing&,
                                                                double within);
    /// Whether range_and_bearing would not be empty: the same robots are asked, in the same order.
    [[nodiscard]] bool somebody_within(std::size_t robot, const RangeAndBearing&, double within);
    /// How many sensors of the ring the light reaches; other robots throw shadows.
    [[nodiscard]] std::uint32_t lit_sensors(std::size_t robot, const LightRing&, Vector light);
    /// The distance from the body to the nearest robot or wall that a sensor of the ring meets; nothing in range: none.
    [[nodiscard]] std::optional<double> nearest(std::size_t robot, const ProximityRing&) const;

private:
    static constexpr std::uint32_t nobody = 0xffffffffU;

    [[nodiscard]] double first_disk(Vector origin, Vector direction, double range, std::uint32_t self,
                                    std::uint32_t other) const;
    [[nodiscard]] double first_disk_in_cells(Vector origin, Vector direction, double range, std::uint32_t self,
                                             std::uint32_t other) const;
    [[nodiscard]] double first_wall(Vector origin, Vector direction, double range) const;
    [[nodiscard]] Sight cast(Vector origin, Vector direction, double range, std::uint32_t self) const;
    [[nodiscard]] bool hidden(Vector from, Vector to, std::uint32_t self, std::uint32_t other) const;
    [[nodiscard]] std::optional<Bearing> hear(std::uint32_t robot, std::uint32_t other, const RangeAndBearing&,
                                              double within);
    void neighbours(std::size_t robot, double reach);

    [[nodiscard]] bool is_silent(std::size_t robot) const { return robot < silent_.size() && silent_[robot]; }

    World& world_;
    std::vector<bool> silent_;  ///< empty while no radio has failed
    Cells cells_;
    bool indexed_ = false;
    std::vector<std::uint32_t> near_;
    std::vector<Bearing> heard_;
};

}  // namespace robochart::simulation
