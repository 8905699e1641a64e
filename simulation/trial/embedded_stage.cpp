// SPDX-License-Identifier: Apache-2.0
// Implements a stage for the built-in world.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/scenario/read_scenario.hpp"
#include "simulation/trial/stage.hpp"
#include "simulation/world/sensing.hpp"

namespace robochart::simulation {

namespace {

class EmbeddedStage final : public Stage {
public:
    EmbeddedStage(const Scenario& scenario, World world)
        : scenario_(scenario), world_(std::move(world)), sensing_(world_) {
        for (const Light& light : scenario.lights) lights_.push_back({light.at});
    }

    [[nodiscard]] std::size_t size() const override { return world_.size(); }
    [[nodiscard]] Pose pose(std::size_t robot) const override {
        return {world_.position(robot), world_.heading(robot)};
    }

    void sense() override { sensing_.update_positions(); }
    [[nodiscard]] Sight line_of_sight(std::size_t robot, const Sensor& sensor) override {
        const Sight sight = sensing_.line_of_sight(robot, sensor.sight_range);
        if (sight.what == Seen::robot)
            return world_.random().draw_chance(sensor.false_negative) ? Sight{Seen::nothing, 0} : sight;
        return world_.random().draw_chance(sensor.false_positive) ? Sight{Seen::robot, sight.distance} : sight;
    }
    [[nodiscard]] std::vector<std::uint32_t> robots_within(std::size_t robot, const Sensor& sensor,
                                                           double distance) override {
        std::vector<std::uint32_t> numbers;
        for (const Bearing& other : sensing_.range_and_bearing(robot, sensor.range_and_bearing, distance))
            numbers.push_back(other.robot);
        return numbers;
    }
    void set_lights(const std::vector<LightNow>& lights) override { lights_ = lights; }
    void set_obstacle(std::size_t obstacle, bool there) override { world_.set_obstacle(obstacle, there); }
    void silence(std::size_t robot) override { sensing_.silence(robot); }
    [[nodiscard]] bool somebody_within(std::size_t robot, const Sensor& sensor, double distance) override {
        return sensing_.somebody_within(robot, sensor.range_and_bearing, distance);
    }
    [[nodiscard]] std::optional<double> direction_of_others(std::size_t robot, const Sensor& sensor,
                                                            double distance) override {
        Vector sum;
        const auto& heard = sensing_.range_and_bearing(robot, sensor.range_and_bearing, distance);
        for (const Bearing& other : heard)
            sum = sum + other.distance * Vector{std::cos(other.angle), std::sin(other.angle)};
        if (heard.empty()) return std::nullopt;
        return std::atan2(sum.y, sum.x);
    }
    [[nodiscard]] std::uint32_t lit_sensors(std::size_t robot, const Sensor& sensor) override {
        for (std::size_t light = 0; light < lights_.size(); ++light)
            if (scenario_.lights[light].name.text == sensor.source.text && lights_[light].on)
                return sensing_.lit_sensors(robot, sensor.light_ring, lights_[light].at);
        return 0;
    }
    [[nodiscard]] bool close_within(std::size_t robot, const Sensor& sensor, double distance) override {
        const auto nearest = sensing_.nearest_distance(robot, sensor.proximity);
        return nearest && *nearest <= distance;
    }

    void set_wheels(std::size_t robot, Wheels wheels) override { world_.set_wheels(robot, wheels); }
    void advance() override { world_.advance(); }

private:
    const Scenario& scenario_;
    World world_;
    Sensing sensing_;
    std::vector<LightNow> lights_;
};

}  // namespace

std::unique_ptr<Stage> embedded_stage(const Scenario& scenario, std::uint32_t trial,
                                      diagnostics::Diagnostics& diagnostics) {
    auto world = start(scenario, trial, diagnostics);
    if (!world) return nullptr;
    return std::make_unique<EmbeddedStage>(scenario, std::move(*world));
}

}  // namespace robochart::simulation
