// What follows from a scenario's parts.
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
        default:
            return parts.front().of_trial();
    }
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
        default:
            return Dimension::share;
    }
}

std::uint64_t Scenario::steps() const {
    return static_cast<std::uint64_t>(std::llround(duration / world.control_step));
}

std::uint64_t Scenario::steps_apart() const {
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

Vector Light::position(double time) const {
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
    return first_robot(kinds());
}

std::uint32_t Scenario::first_robot(std::size_t number) const {
    std::uint32_t before = 0;
    for (std::size_t kind = 0; kind < number; ++kind) before += kind_at(kind).robots;
    return before;
}

std::optional<std::size_t> kind_named(const Scenario& scenario, std::string_view name) {
    for (std::size_t kind = 0; kind < scenario.kinds(); ++kind)
        if (!name.empty() && scenario.kind_at(kind).kind.text == name) return kind;
    return std::nullopt;
}

}  // namespace robochart::simulation
