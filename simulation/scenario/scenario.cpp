// SPDX-License-Identifier: Apache-2.0
// Computes values that are derived from a scenario.
#include "simulation/scenario/scenario.hpp"

#include <algorithm>
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
        case Kind::negation:
        case Kind::both:
        case Kind::either:
            break;
    }
    return parts.front().of_trial();
}

Dimension dimension_of(MeasureKind kind) {
    switch (kind) {
        case MeasureKind::spread:
        case MeasureKind::distance:
            return Dimension::length;
        case MeasureKind::second_moment:
            return Dimension::number;
        case MeasureKind::time:
            return Dimension::time;
        case MeasureKind::cluster:
        case MeasureKind::reached:
        case MeasureKind::inside:
        case MeasureKind::in_state:
        case MeasureKind::working:
        case MeasureKind::kept:
            break;
    }
    return Dimension::share;
}

std::uint64_t Scenario::step_count() const {
    return static_cast<std::uint64_t>(std::llround(duration / world.control_step));
}

std::uint64_t Scenario::steps_between_samples() const {
    return static_cast<std::uint64_t>(std::llround(abstraction->every / world.control_step));
}

bool can_err(SensorKind kind) {
    return kind == SensorKind::line_of_sight || kind == SensorKind::proximity || kind == SensorKind::ground;
}

std::vector<double*> shares_of(Sensor& sensor, std::string_view option) {
    const auto is = [&](SensorKind kind, std::string_view name) { return sensor.kind == kind && option == name; };
    const bool detects = can_err(sensor.kind);
    if (detects && option == "error") return {&sensor.false_negative, &sensor.false_positive};
    if (detects && option == "false_negative") return {&sensor.false_negative};
    if (detects && option == "false_positive") return {&sensor.false_positive};
    if (is(SensorKind::range_and_bearing, "loss")) return {&sensor.range_and_bearing.loss};
    if (is(SensorKind::light, "leak")) return {&sensor.light_ring.leak};
    return {};
}

Vector Light::position_at(double time) const {
    const Vector way = to - at;
    const double far = length(way);
    if (speed <= 0 || far == 0) return at;
    return at + std::min(1.0, speed * time / far) * way;
}

void Scenario::set_trials(std::uint32_t count) {
    trials = count;
    for (Claim& claim : claims)
        if (claim.estimate) claim.trials = count;
}

void Scenario::set_robots(std::uint32_t count) {
    robots = count;
    if (arena_area > 0) world.arena.width = world.arena.height = std::sqrt(arena_area * all_robots());
}

std::uint32_t Scenario::all_robots() const {
    return first_robot(kind_count());
}

std::uint32_t Scenario::first_robot(std::size_t number) const {
    std::uint32_t before = 0;
    for (std::size_t earlier = 0; earlier < number; ++earlier) before += kind_at(earlier).robots;
    return before;
}

Body Scenario::body_of(std::size_t number) const {
    const OwnDrive& drive = kind_at(number).own;
    Body body = world.body;
    body.axle = drive.axle.value_or(body.axle);
    body.max_wheel = drive.max_wheel.value_or(body.max_wheel);
    body.noise = drive.noise.value_or(body.noise);
    return body;
}

std::string Scenario::controller_name(std::size_t number) const {
    return number < kind_count() ? kind_at(number).kind.text : "environment";
}

std::optional<std::size_t> kind_named(const Scenario& scenario, std::string_view name) {
    for (std::size_t kind = 0; kind < scenario.kind_count(); ++kind)
        if (!name.empty() && scenario.kind_at(kind).kind.text == name) return kind;
    return std::nullopt;
}

std::optional<std::size_t> controller_named(const Scenario& scenario, std::string_view name) {
    for (std::size_t number = 0; number < scenario.controller_count(); ++number)
        if (!name.empty() && scenario.controller_name(number) == name) return number;
    return std::nullopt;
}

std::vector<std::string> controller_names(const Scenario& scenario) {
    std::vector<std::string> names;
    for (std::size_t number = 0; number < scenario.controller_count(); ++number)
        if (!scenario.controller_name(number).empty()) names.push_back(scenario.controller_name(number));
    return names;
}

std::optional<AddressedConstant> find_constant_address(const Scenario& scenario, const std::string& name) {
    const std::size_t point = name.find('.');
    if (point == std::string::npos) return AddressedConstant{0, name};
    const auto controller = controller_named(scenario, std::string_view(name).substr(0, point));
    if (!controller) return std::nullopt;
    return AddressedConstant{*controller, name.substr(point + 1)};
}

}  // namespace robochart::simulation
