// SPDX-License-Identifier: Apache-2.0
// The positions and perceptions of robots, in the built-in world or in another simulator behind an adapter. All
// simulators use the order of Enki and of ARGoS: sense, run the controllers, act, simulate one control step.
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

    /// Takes the readings of all sensors for this control cycle.
    virtual void sense() = 0;
    [[nodiscard]] virtual Sight line_of_sight(std::size_t robot, const Sensor&) = 0;
    [[nodiscard]] virtual bool somebody_within(std::size_t robot, const Sensor&, double distance) = 0;
    /// The direction of the vector sum of the robots within a distance, relative to the heading; no value without
    /// robots.
    [[nodiscard]] virtual std::optional<double> direction_of_others(std::size_t robot, const Sensor&,
                                                                    double distance) = 0;
    [[nodiscard]] virtual std::uint32_t lit_sensors(std::size_t robot, const Sensor&) = 0;
    [[nodiscard]] virtual bool close_within(std::size_t robot, const Sensor&, double distance) = 0;

    /// The numbers of the robots that are heard within a distance, ascending; for counts and messages.
    [[nodiscard]] virtual std::vector<std::uint32_t> robots_within(std::size_t, const Sensor&, double /*distance*/) {
        return {};
    }
    /// Sets the lights from now on.
    virtual void set_lights(const std::vector<LightNow>&) {}
    /// Makes an obstacle of Scenario::obstacles appear or vanish.
    virtual void set_obstacle(std::size_t /*obstacle*/, bool /*there*/) {}
    /// Makes the radio of a robot fail.
    virtual void silence(std::size_t) {}

    virtual void set_wheels(std::size_t robot, Wheels) = 0;
    /// Simulates one control step.
    virtual void advance() = 0;
};

/// Makes the start of a trial. On failure the result is null, and diagnostics contain the reason.
using StageMaker =
    std::function<std::unique_ptr<Stage>(const Scenario&, std::uint32_t trial, diagnostics::Diagnostics&)>;

/// The built-in world.
[[nodiscard]] std::unique_ptr<Stage> embedded_stage(const Scenario&, std::uint32_t trial, diagnostics::Diagnostics&);

}  // namespace robochart::simulation
