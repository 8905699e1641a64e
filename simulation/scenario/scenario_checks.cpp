// SPDX-License-Identifier: Apache-2.0
// Checks the consistency of a scenario, and whether its robots fit.
#include "simulation/scenario/read_scenario.hpp"
#include "simulation/scenario/scenario_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/scenario/rules.hpp"

namespace robochart::simulation {

void ScenarioReader::check_scenario() {
    for (const auto& [word, what] : {std::pair("step", "the control step"), std::pair("physics", "the physics step"),
                                     std::pair("duration", "the duration"), std::pair("arena", "the arena"),
                                     std::pair("robots", "the number of robots")})
        if (!said_.contains(word)) in_.report(rules::missing, whole_, {what});
    set_unit();
    if (said_.contains("robots") && scenario_.placements.empty())
        in_.report(rules::missing, robots_span_, {"the places of the robots"});
    scenario_.set_robots(scenario_.robots);
    scenario_.set_trials(scenario_.trials);
    check_steps();
    check_places();
    check_lights();
    check_abstraction();
    check_failures();
    for (const Variation& variation : scenario_.variations) {
        const auto varies = [&](const Failure& failure) {
            return (failure.mean_time > 0) == (variation.what == Varied::mean_time);
        };
        if ((variation.what == Varied::failed || variation.what == Varied::mean_time) &&
            std::ranges::none_of(scenario_.failures, varies))
            in_.report(rules::missing, variation.span,
                       {variation.what == Varied::failed ? "the failure (failure of KIND at TIME in N robots)"
                                                         : "the failure (failure of KIND with mean time TIME)"});
    }
    for (const auto& [time, span] : times_)
        if (said_.contains("duration") && time > scenario_.duration)
            in_.report(rules::out_of_range, span,
                       {fmt::format("{} s is after the end, {} s", time, scenario_.duration)});
}

/// Sets the time unit to that of the item or, without an item, to the declared one.
void ScenarioReader::set_unit() {
    if (said_.contains("unit")) {
        scenario_.unit_span = span_of_item("unit");
    } else if (declared_) {
        scenario_.time_unit = static_cast<double>(*declared_) / static_cast<double>(durations::second);
    } else {
        in_.report(
            rules::missing, whole_,
            {"the length of a time unit of the model: `unit 0.1 s` here, or in a .claims file beside the model"});
    }
}

/// Checks that a scenario does not let more robots fail than exist. If the number of robots varies, each point is
/// checked with its own number.
void ScenarioReader::check_failures() {
    const auto varied = [&](Varied what) {
        return std::ranges::find_if(scenario_.variations,
                                    [&](const Variation& variation) { return variation.what == what; });
    };
    const auto none = scenario_.variations.end();
    const auto refuse = [&](diagnostics::Span span, double failing, std::uint32_t robots) {
        if (failing > robots)
            in_.report(rules::out_of_range, span, {fmt::format("{:g} robots fail of {}", failing, robots)});
    };
    if (varied(Varied::robots) == none && varied(Varied::failed) != none)
        refuse(varied(Varied::failed)->span, varied(Varied::failed)->values.back(), scenario_.robots);
    for (std::size_t kind = 0; kind < scenario_.kind_count(); ++kind)
        for (const Failure& failure : scenario_.kind_at(kind).failures)
            if (kind > 0 || (varied(Varied::robots) == none && varied(Varied::failed) == none))
                refuse(failure.span, failure.robots, scenario_.kind_at(kind).robots);
}

diagnostics::Span ScenarioReader::span_of_item(std::string_view word) const {
    const auto found = said_.find(word);
    return found == said_.end() ? whole_ : found->second;
}

std::uint64_t ScenarioReader::divide_evenly(double whole, const char* whole_name, double part, const char* part_name,
                                            std::string_view word) {
    const double times = std::round(whole / part);
    if (times < 1 || std::abs(times * part - whole) > 1e-9 * whole || times > 1e6) {
        in_.report(rules::uneven_steps, span_of_item(word), {whole_name, part_name});
        return 1;
    }
    return static_cast<std::uint64_t>(times);
}

void ScenarioReader::check_steps() {
    const double step = scenario_.world.control_step;
    if (!said_.contains("step") || step <= 0) return;
    if (physics_ > 0)
        scenario_.world.physics_steps = static_cast<std::uint32_t>(
            divide_evenly(step, "the control step", physics_, "the physics step", "physics"));
    if (scenario_.time_unit > 0)
        scenario_.units_per_step = static_cast<std::uint32_t>(
            divide_evenly(step, "the control step", scenario_.time_unit, "the time unit", "unit"));
    if (scenario_.duration > 0 && scenario_.duration < step)
        in_.report(rules::out_of_range, span_of_item("duration"), {"the duration is shorter than a control step"});
    if (scenario_.duration / step > 1e8)
        in_.report(rules::out_of_range, span_of_item("duration"),
                   {"the duration is more than 100,000,000 control steps"});
}

void ScenarioReader::check_places() {
    const Arena& arena = scenario_.world.arena;
    if (!said_.contains("arena")) return;
    diagnostics::Span last;  // several corners of one obstacle are reported once
    for (const Inside& place : inside_) {
        const bool outside = std::abs(place.at.x) > arena.width / 2 || std::abs(place.at.y) > arena.height / 2;
        if (!arena.walled || !outside || place.span == last) continue;
        in_.report(rules::out_of_range, place.span, {fmt::format("{} is outside the arena", place.what)});
        last = place.span;
    }
}

void ScenarioReader::check_lights() {
    for (const Sensor& sensor : scenario_.sensors)
        if (!sensor.source.text.empty()) (void)light_named(sensor.source);
}

namespace {

Region region_around(Vector centre, double width, double height) {
    const Vector half{width / 2, height / 2};
    return {centre - half, centre + half};
}

/// Returns the region in which this number of robots is placed at random.
Region region_of(const Placement& placement, std::size_t robots, const Arena& arena) {
    switch (placement.kind) {
        case Placement::Kind::square: {
            const double side = std::sqrt(placement.area * static_cast<double>(robots));
            return region_around(placement.pose.at, side, side);
        }
        case Placement::Kind::arena:
            return region_around({}, arena.width, arena.height);
        case Placement::Kind::pose:
        case Placement::Kind::region:
        case Placement::Kind::linked:
            break;
    }
    return placement.region;
}

bool is_beyond(const Region& region, const Arena& arena) {
    constexpr double rounding = 1e-9;
    const double x = std::max(std::abs(region.low.x), std::abs(region.high.x));
    const double y = std::max(std::abs(region.low.y), std::abs(region.high.y));
    return arena.walled && (x > arena.width / 2 + rounding || y > arena.height / 2 + rounding);
}

}  // namespace

void refuse_beyond(const Scenario& scenario, const char* simulator, diagnostics::Diagnostics& diagnostics) {
    const auto refuse = [&](diagnostics::Span span, const char* what) {
        diagnostics.report(rules::not_there, span, {simulator, what});
    };
    for (const Sensor& sensor : scenario.sensors) {
        if (sensor.false_negative > 0 || sensor.false_positive > 0)
            refuse(sensor.name.span,
                   sensor.kind == SensorKind::line_of_sight ? "errors of a line of sight" : "errors of sensors");
        if (!sensor.message.text.empty()) refuse(sensor.name.span, "messages with values");
        if (sensor.kind == SensorKind::ground) refuse(sensor.name.span, "sensors for the ground");
    }
    for (const Feed& feed : scenario.feeds)
        if (feed.reading == Reading::count) refuse(feed.span, "counts of neighbours");
    for (const Failure& failure : scenario.failures) refuse(failure.span, "failures of robots");
    for (const Light& light : scenario.lights)
        if (light.speed > 0) refuse(light.span, "lights that move");
    for (const Obstacle& obstacle : scenario.obstacles) refuse(obstacle.name.span, "obstacles that come and go");
    for (const RobotKind& kind : scenario.others) refuse(kind.component.span, "several kinds of robots");
    if (scenario.environment) refuse(scenario.environment->component.span, "a machine of the environment");
}

namespace {

/// Places the robots of a kind. If there are several regions, each gets an equal part; if the number cannot be divided
/// evenly, the first regions get one robot more. Returns false and reports a finding if the robots do not fit.
bool place_robots(World& world, const Scenario& scenario, const RobotKind& kind,
                  diagnostics::Diagnostics& diagnostics) {
    const auto fixed = static_cast<std::size_t>(std::ranges::count_if(
        kind.placements, [](const Placement& placement) { return placement.kind == Placement::Kind::pose; }));
    std::size_t regions = kind.placements.size() - fixed;
    const auto refuse = [&](std::size_t robots, diagnostics::Span span) {
        diagnostics.report(rules::no_space, span,
                           {std::to_string(robots), fmt::format("{}", scenario.world.body.radius)});
        return false;
    };
    if (fixed > kind.robots || (regions == 0 && fixed < kind.robots)) {
        const std::string cause = fmt::format("{} robots, but places for {}", kind.robots, fixed);
        diagnostics.report(rules::out_of_range, kind.placements.back().span, {cause});
        return false;
    }
    for (const Placement& placement : kind.placements)
        if (placement.kind == Placement::Kind::pose) world.add_robot(placement.pose);
    std::size_t left = kind.robots - fixed;
    for (const Placement& placement : kind.placements) {
        if (placement.kind == Placement::Kind::pose) continue;
        const std::size_t here = (left + regions - 1) / regions;
        left -= here;
        --regions;
        if (placement.kind == Placement::Kind::linked) {
            const double least = 2 * scenario.world.body.radius;
            // The tolerance is needed because 3.5 cm and 0.035 m are not the same double.
            if (placement.link < least * (1 - 1e-9)) {
                diagnostics.report(
                    rules::out_of_range, placement.span,
                    {fmt::format("robots that are linked are at least a diameter apart, {:g} cm", least)});
                return false;
            }
            if (!world.place_linked(here, placement.pose.at, std::max(placement.link, least)))
                return refuse(here, placement.span);
            continue;
        }
        const Region region = region_of(placement, here, scenario.world.arena);
        if (is_beyond(region, scenario.world.arena)) {
            diagnostics.report(rules::out_of_range, placement.span, {"the place of robots is outside the arena"});
            return false;
        }
        const Vector extent = region.high - region.low;
        const double radius = scenario.world.body.radius;
        const double cover = static_cast<double>(here) * std::numbers::pi * radius * radius;
        if (cover > 0.4 * extent.x * extent.y || !world.place_at_random(here, region))
            return refuse(here, placement.span);
    }
    return true;
}

}  // namespace

std::optional<World> start(const Scenario& scenario, std::uint32_t trial, diagnostics::Diagnostics& diagnostics) {
    World world(scenario.world, scenario.seed + trial);
    for (const Obstacle& obstacle : scenario.obstacles) world.add_obstacle(obstacle.corners, obstacle.there);
    for (std::size_t kind = 0; kind < scenario.kind_count(); ++kind) {
        world.set_body(scenario.body_of(kind));
        if (!place_robots(world, scenario, scenario.kind_at(kind), diagnostics)) return std::nullopt;
    }
    return world;
}

}  // namespace robochart::simulation
