// SPDX-License-Identifier: Apache-2.0
// Writes a scenario as the text of an ARGoS experiment. ARGoS uses metres and degrees.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "simulation/adapters/argos/argos_stage.hpp"

namespace robochart::simulation {

namespace {

constexpr double wall_height = 0.3;
/// Lights are lower than the robots (8.6 cm), so that robots cast shadows.
constexpr double light_height = 0.06;
constexpr double thickness = 0.1;

double metres(double centimetres) {
    return centimetres / 100;
}

std::string at(double x, double y, double z) {
    return fmt::format("{:.9f},{:.9f},{:.9f}", x, y, z);
}

std::string box(const std::string& id, double x, double y, double length, double width, double angle) {
    return fmt::format(
        "    <box id=\"{}\" size=\"{}\" movable=\"false\"><body position=\"{}\" orientation=\"{:.9f},0,0\"/></box>\n",
        id, at(length, width, wall_height), at(x, y, 0), angle * 180 / std::numbers::pi);
}

/// Writes the walls. The walls of the arena are outside its rectangle; inner walls are a millimetre thick.
std::string walls(const Arena& arena) {
    std::string text;
    const double half_width = metres(arena.width) / 2;
    const double half_height = metres(arena.height) / 2;
    if (arena.walled) {
        const double x = half_width + thickness / 2;
        const double y = half_height + thickness / 2;
        const double across = 2 * half_height + 2 * thickness;
        text += box("wall_east", x, 0, thickness, across, 0) + box("wall_west", -x, 0, thickness, across, 0);
        text += box("wall_north", 0, y, 2 * half_width, thickness, 0);
        text += box("wall_south", 0, -y, 2 * half_width, thickness, 0);
    }
    for (std::size_t i = 0; i < arena.walls.size(); ++i) {
        const Vector way = arena.walls[i].to - arena.walls[i].from;
        const Vector middle = 0.5 * (arena.walls[i].from + arena.walls[i].to);
        text += box(fmt::format("wall{}", i), metres(middle.x), metres(middle.y), metres(length(way)), 0.001,
                    std::atan2(way.y, way.x));
    }
    return text;
}

const Sensor* sensor_of(const Scenario& scenario, SensorKind kind) {
    for (const Sensor& sensor : scenario.sensors)
        if (sensor.kind == kind) return &sensor;
    return nullptr;
}

std::string controller(const Scenario& scenario) {
    const Sensor* const radio = sensor_of(scenario, SensorKind::range_and_bearing);
    std::string text = fmt::format("  <controllers>\n    <{0} id=\"{0}\">\n      <actuators>\n", argos_controller);
    text += "        <differential_steering implementation=\"default\"/>\n";
    if (radio != nullptr) text += "        <range_and_bearing implementation=\"default\"/>\n";
    text += "      </actuators>\n      <sensors>\n";
    if (radio != nullptr)
        text += fmt::format(
            "        <range_and_bearing implementation=\"medium\" medium=\"radio\" noise_std_dev=\"{}\" "
            "packet_drop_prob=\"{}\"/>\n",
            metres(radio->range_and_bearing.noise), radio->range_and_bearing.loss);
    if (sensor_of(scenario, SensorKind::light) != nullptr) text += "        <light implementation=\"default\"/>\n";
    return text + fmt::format("      </sensors>\n      <params/>\n    </{}>\n  </controllers>\n", argos_controller);
}

std::string robots(const Scenario& scenario, const World& start) {
    const Sensor* const radio = sensor_of(scenario, SensorKind::range_and_bearing);
    const double range = radio != nullptr ? metres(radio->range_and_bearing.range) : 0.1;
    std::string text;
    for (std::size_t i = 0; i < start.size(); ++i)
        text += fmt::format(
            "    <e-puck id=\"{}{}\" rab_range=\"{}\" rab_data_size=\"1\"><body position=\"{}\" "
            "orientation=\"{:.9f},0,0\"/>"
            "<controller config=\"{}\"/></e-puck>\n",
            argos_robot, i, range, at(metres(start.position(i).x), metres(start.position(i).y), 0),
            start.heading(i) * 180 / std::numbers::pi, argos_controller);
    return text;
}

std::string lights(const Scenario& scenario) {
    std::string text;
    for (const Light& light : scenario.lights)
        text += fmt::format(
            "    <light id=\"light_{}\" position=\"{}\" orientation=\"0,0,0\" color=\"yellow\" intensity=\"10\" "
            "medium=\"leds\"/>\n",
            light.name.text, at(metres(light.at.x), metres(light.at.y), light_height));
    return text;
}

/// Writes the grids of the media, with cells of about a metre.
std::string grid(double width, double height) {
    return fmt::format("index=\"grid\" grid_size=\"{},{},1\"", static_cast<int>(std::ceil(width)),
                       static_cast<int>(std::ceil(height)));
}

}  // namespace

std::string argos_experiment(const Scenario& scenario, const World& start) {
    const WorldOptions& world = scenario.world;
    // Without walls, the space contains all points that the robots can reach.
    const double around = world.arena.walled ? 4 * thickness : 2 * metres(world.body.max_wheel) * scenario.duration + 1;
    const double width = metres(world.arena.width) + around;
    const double height = metres(world.arena.height) + around;
    const Sensor* const radio = sensor_of(scenario, SensorKind::range_and_bearing);
    std::string text = "<?xml version=\"1.0\" ?>\n<argos-configuration>\n";
    text += fmt::format(
        "  <framework><system threads=\"0\"/><experiment length=\"0\" ticks_per_second=\"{}\" random_seed=\"{}\"/>"
        "</framework>\n",
        std::llround(1 / world.control_step), scenario.seed);
    text += controller(scenario);
    text += fmt::format("  <arena size=\"{}\" center=\"0,0,0.5\">\n", at(width, height, 1));
    text += walls(world.arena) + lights(scenario) + robots(scenario, start) + "  </arena>\n";
    text += fmt::format("  <physics_engines><dynamics2d id=\"physics\" iterations=\"{}\"/></physics_engines>\n",
                        world.physics_steps);
    text += "  <media>\n";
    if (radio != nullptr)
        text += fmt::format("    <range_and_bearing id=\"radio\" check_occlusions=\"{}\" {}/>\n",
                            radio->range_and_bearing.occlusion, grid(width, height));
    if (!scenario.lights.empty()) text += fmt::format("    <led id=\"leds\" {}/>\n", grid(width, height));
    return text + "  </media>\n</argos-configuration>\n";
}

}  // namespace robochart::simulation
