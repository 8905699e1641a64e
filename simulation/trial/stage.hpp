// SPDX-License-Identifier: Apache-2.0
// Declares the interface for the positions and perceptions of robots. The built-in world implements it, and so do
// adapters of other simulators. All simulators use the order of Enki and of ARGoS: sense, run the controllers, act,
// simulate one control step.
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
    /// Returns the direction of the sum of the vectors to all robots within a distance, relative to the heading.
    /// Returns no value if there are no robots.
    [[nodiscard]] virtual std::optional<double> direction_of_others(std::size_t robot, const Sensor&,
                                                                    double distance) = 0;
    [[nodiscard]] virtual std::uint32_t lit_sensors(std::size_t robot, const Sensor&) = 0;
    [[nodiscard]] virtual bool close_within(std::size_t robot, const Sensor&, double distance) = 0;

    /// Returns the numbers of the robots that are heard within a distance, ascending. Used for counts and messages.
    [[nodiscard]] virtual std::vector<std::uint32_t> robots_within(std::size_t, const Sensor&, double /*distance*/) {
        return {};
    }
    /// Sets the states of the lights from now on.
    virtual void set_lights(const std::vector<LightNow>&) {}
    /// Makes an obstacle of Scenario::obstacles appear or vanish.
    virtual void set_obstacle(std::size_t /*obstacle*/, bool /*there*/) {}
    /// Makes the radio of a robot fail.
    virtual void silence(std::size_t) {}

    virtual void set_wheels(std::size_t robot, Wheels) = 0;
    /// Simulates one control step.
    virtual void advance() = 0;
};

/// Makes a stage at the start of a trial. If this fails, the result is null and the diagnostics contain the reason.
using StageMaker =
    std::function<std::unique_ptr<Stage>(const Scenario&, std::uint32_t trial, diagnostics::Diagnostics&)>;

/// Makes a stage for the built-in world.
[[nodiscard]] std::unique_ptr<Stage> embedded_stage(const Scenario&, std::uint32_t trial, diagnostics::Diagnostics&);

}  // namespace robochart::simulation
