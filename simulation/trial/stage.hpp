// Where robots are and what they perceive: the embedded world, or another simulator behind an adapter. One order for
// all: sense, controllers, act, one control step (the order of Enki and of ARGoS).
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "simulation/scenario/scenario.hpp"

namespace robochart::simulation {

class Stage {
public:
    virtual ~Stage() = default;

    [[nodiscard]] virtual std::size_t size() const = 0;
    [[nodiscard]] virtual Pose pose(std::size_t robot) const = 0;

    /// The sensors of this control cycle look now.
    virtual void sense() = 0;
    [[nodiscard]] virtual Sight line_of_sight(std::size_t robot, const Sensor&) = 0;
    [[nodiscard]] virtual bool somebody_within(std::size_t robot, const Sensor&, double distance) = 0;
    /// The direction, from the heading, of the vector sum of the robots within a distance; none without any.
    [[nodiscard]] virtual std::optional<double> direction_of_others(std::size_t robot, const Sensor&,
                                                                    double distance) = 0;
    [[nodiscard]] virtual std::uint32_t lit_sensors(std::size_t robot, const Sensor&) = 0;
    [[nodiscard]] virtual bool close_within(std::size_t robot, const Sensor&, double distance) = 0;

    /// The numbers of the robots heard within a distance, ascending; for counts and messages.
    [[nodiscard]] virtual std::vector<std::uint32_t> robots_within(std::size_t, const Sensor&, double /*distance*/) {
        return {};
    }
    /// The lights as they are from now on.
    virtual void set_lights(const std::vector<LightNow>&) {}
    /// An obstacle of Scenario::obstacles comes or goes.
    virtual void set_obstacle(std::size_t /*obstacle*/, bool /*there*/) {}
    /// The radio of a robot fails.
    virtual void silence(std::size_t) {}

    virtual void set_wheels(std::size_t robot, Wheels) = 0;
    /// One control step passes.
    virtual void advance() = 0;
};

/// Makes the start of a trial. On failure returns nothing; diagnostics tell.
using StageMaker =
    std::function<std::unique_ptr<Stage>(const Scenario&, std::uint32_t trial, diagnostics::Diagnostics&)>;

/// The embedded world.
[[nodiscard]] std::unique_ptr<Stage> embedded_stage(const Scenario&, std::uint32_t trial, diagnostics::Diagnostics&);

}  // namespace robochart::simulation
