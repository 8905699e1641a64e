// SPDX-License-Identifier: Apache-2.0
// See claims.hpp.
#include "simulation/report/claims.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "simulation/report/percent.hpp"

namespace robochart::simulation {

std::uint64_t ClaimResult::stopped_count() const {
    return static_cast<std::uint64_t>(
        std::ranges::count_if(outcomes, [](const ClaimOutcome& outcome) { return outcome.stopped; }));
}

ClaimJudge::ClaimJudge(const Claim& claim, std::uint32_t comparisons)
    : claim_(claim), looks_(claim.trials, (1 - claim.confidence) / comparisons) {
    result_.error = (1 - claim.confidence) / comparisons;
    sprt_ = {claim.probability + claim.indifference, claim.probability - claim.indifference, result_.error,
             result_.error};
}

void ClaimJudge::add(const ClaimOutcome& outcome, std::uint64_t steps) {
    result_.outcomes.push_back(outcome);
    result_.successes += outcome.holds ? 1U : 0U;
    result_.steps += steps;
    if (claim_.estimate)
        update_estimate();
    else if (claim_.indifference > 0)
        run_test();
    else
        update_interval();
    done_ = done_ || result_.trial_count() >= claim_.trials;
}

void ClaimJudge::update_interval() {
    const auto interval = looks_.interval_after(result_.successes, result_.trial_count());
    if (!interval) return;
    result_.interval = *interval;
    result_.looked = result_.trial_count();
    const double p = claim_.probability;
    const bool above = claim_.at_least ? interval->low >= p : interval->low > p;
    const bool below = claim_.at_least ? interval->high < p : interval->high <= p;
    if (above || below) set_verdict(above);
}

void ClaimJudge::update_estimate() {
    if (result_.trial_count() < claim_.trials) return;
    result_.interval = statistics::clopper_pearson(result_.successes, result_.trial_count(), result_.error);
    result_.looked = result_.trial_count();
    result_.verdict = ClaimVerdict::estimated;
}

void ClaimJudge::run_test() {
    const statistics::Sprt::Answer answer = sprt_.answer(result_.successes, result_.trial_count());
    if (answer != statistics::Sprt::Answer::open) set_verdict(answer == statistics::Sprt::Answer::at_least);
}

void ClaimJudge::set_verdict(bool above) {
    result_.verdict = above == claim_.at_least ? ClaimVerdict::holds : ClaimVerdict::fails;
    done_ = true;
}

std::string verdict_word(ClaimVerdict verdict) {
    switch (verdict) {
        case ClaimVerdict::holds:
            return "holds";
        case ClaimVerdict::fails:
            return "fails";
        case ClaimVerdict::estimated:
            return "estimated";
        case ClaimVerdict::open:
            break;
    }
    return "open";
}

std::string evidence_text(const Claim& claim, const ClaimResult& found) {
    std::string text = fmt::format("{} of {} trials", found.successes, found.trial_count());
    if (claim.indifference > 0)
        text += fmt::format("; test of at least {} against at most {}, each answer wrong with at most {}",
                            percent_text(claim.probability + claim.indifference),
                            percent_text(claim.probability - claim.indifference), percent_text(found.error));
    else if (found.looked > 0)
        text +=
            fmt::format("; between {} and {}{}", percent_below(found.interval.low), percent_above(found.interval.high),
                        found.looked == found.trial_count() ? "" : fmt::format(" (after {} trials)", found.looked));
    if (found.verdict == ClaimVerdict::open)
        text += found.trial_count() >= claim.trials ? "; no more trials are allowed" : "; it needs more trials";
    if (const std::uint64_t stopped = found.stopped_count(); stopped > 0)
        text += fmt::format("; {} of them stopped by a controller, counted against it", stopped);
    return text;
}

namespace {

std::string errors_text(const Sensor& sensor) {
    return sensor.false_negative > 0 || sensor.false_positive > 0
               ? fmt::format("missed in {}, seen where there is none in {} of looks",
                             percent_text(sensor.false_negative), percent_text(sensor.false_positive))
               : "without errors";
}

std::string sensor_line(const Sensor& sensor) {
    std::string text = fmt::format("sensor {}: ", sensor.name.text);
    const auto range = [](double cm) { return cm > 0 ? fmt::format("to {:g} cm", cm) : std::string("without limit"); };
    switch (sensor.kind) {
        case SensorKind::line_of_sight:
            return text + fmt::format("line of sight {}, {}", range(sensor.sight_range),
                                      sensor.false_negative > 0 || sensor.false_positive > 0
                                          ? fmt::format("{} of robots missed, {} seen that are not there",
                                                        percent_text(sensor.false_negative),
                                                        percent_text(sensor.false_positive))
                                          : "without errors");
        case SensorKind::range_and_bearing: {
            const RangeAndBearing& radio = sensor.range_and_bearing;
            return text + fmt::format("messages to {:g} cm, {}, {}, {}", radio.range,
                                      radio.occlusion ? "hidden by robots in between" : "through robots in between",
                                      radio.noise > 0
                                          ? fmt::format("distances with a deviation of {:g} cm", radio.noise)
                                          : "exact distances",
                                      radio.loss > 0 ? fmt::format("{} lost", percent_text(radio.loss)) : "none lost");
        }
        case SensorKind::light:
            return text + fmt::format("{} light sensors with shadows, {} leak", sensor.light_ring.sensors,
                                      percent_text(sensor.light_ring.leak));
        case SensorKind::ground:
            return text + fmt::format("the distance to {}, {}", sensor.source.text, errors_text(sensor));
        case SensorKind::proximity:
            return text + fmt::format("{} rays {}, {}", sensor.proximity.sensors, range(sensor.proximity.range),
                                      errors_text(sensor));
    }
    return text;
}

std::string placement_text(const Placement& place) {
    const auto point = [](Vector at) { return fmt::format("({:g} cm, {:g} cm)", at.x, at.y); };
    switch (place.kind) {
        case Placement::Kind::pose:
            return "at " + point(place.pose.at);
        case Placement::Kind::square:
            return fmt::format("at random around {} with {:g} cm2 per robot", point(place.pose.at), place.area);
        case Placement::Kind::arena:
            return "at random in the arena";
        case Placement::Kind::linked:
            return fmt::format("at random around {}, each within {:g} cm of another", point(place.pose.at), place.link);
        case Placement::Kind::region:
            break;
    }
    return fmt::format("at random in {} to {}", point(place.region.low), point(place.region.high));
}

/// Returns " of leaders" if a scenario has several kinds.
std::string of_whom(const Scenario& scenario, const RobotKind& kind) {
    if (scenario.others.empty()) return "";
    return kind.kind.text.empty() ? " of the first kind" : " of " + kind.kind.text;
}

std::string placements_line(const Scenario& scenario, const RobotKind& kind) {
    std::vector<std::string> places;
    for (const Placement& place : kind.placements) places.push_back(placement_text(place));
    constexpr std::size_t most = 4;
    const std::size_t left_out = places.size() > most ? places.size() - most : 0;
    if (left_out > 0) places.resize(most);
    return fmt::format("start{}: {}{}", of_whom(scenario, kind), fmt::join(places, "; "),
                       left_out > 0 ? fmt::format("; and {} more places", left_out) : "");
}

const char* failing_part(const Failure& failure) {
    switch (failure.kind) {
        case FailureKind::motors:
            return "motors";
        case FailureKind::radio:
            return "radio";
        case FailureKind::sensors:
            return "sensors";
        case FailureKind::whole:
            break;
    }
    return "everything";
}

std::string failure_line(const Scenario& scenario, const RobotKind& kind, const Failure& failure) {
    const std::string whose = of_whom(scenario, kind);
    const char* const what = failing_part(failure);
    return failure.mean_time > 0
               ? fmt::format("failures{}: {} of each robot, after {:g} s in the mean, exponentially", whose, what,
                             failure.mean_time)
               : fmt::format("failures{}: {} of {} robots at {:g} s", whose, what, failure.robots, failure.at);
}

std::string act_text(const Scenario& scenario, const WorldAct& act) {
    using Kind = WorldAct::Kind;
    const auto light = [&] { return scenario.lights.at(act.what).name.text; };
    const auto obstacle = [&] { return scenario.obstacles.at(act.what).name.text; };
    switch (act.kind) {
        case Kind::light_on:
        case Kind::light_off:
            return fmt::format("{} switches {} {}", act.on.text, light(), act.kind == Kind::light_on ? "on" : "off");
        case Kind::light_move:
            return fmt::format("{} moves {}{} at {:g} cm/s", act.on.text, light(),
                               act.to ? fmt::format(" to ({:g} cm, {:g} cm)", act.to->x, act.to->y) : "", act.speed);
        case Kind::obstacle_appear:
        case Kind::obstacle_vanish:
            return fmt::format("{} lets {} {}", act.on.text, obstacle(),
                               act.kind == Kind::obstacle_appear ? "appear" : "vanish");
        case Kind::failure:
            return fmt::format("{} lets {} fail of {} robots, drawn at random", act.on.text, failing_part(act.failure),
                               act.failure.robots);
        case Kind::stimulus:
            return fmt::format("{} raises {}", act.on.text, act.stimulus.event.text);
    }
    return "";
}

/// Returns the assumptions about the machine that acts on the world.
std::string environment_line(const Scenario& scenario) {
    const Environment& environment = *scenario.environment;
    std::vector<std::string> parts;
    for (const WorldFeed& feed : environment.feeds) parts.push_back(fmt::format("{} {}", feed.target.text, feed.text));
    for (const WorldAct& act : environment.acts) parts.push_back(act_text(scenario, act));
    return fmt::format(
        "environment {}, a machine whose draws follow from the trial's seed; measures reach it without "
        "error in each cycle, and what it does holds from the next one on: {}",
        environment.component.text, fmt::join(parts, "; "));
}

/// Returns the differences of a kind from the first kind: ", axle of 8 cm, wheels to 6 cm/s, without noise".
std::string drive_differences(const Scenario& scenario, std::size_t kind) {
    const OwnDrive& own = scenario.kind_at(kind).own;
    std::string text;
    if (own.axle) text += fmt::format(", axle of {:g} cm", *own.axle);
    if (own.max_wheel) text += fmt::format(", wheels to {:g} cm/s", *own.max_wheel);
    if (own.noise)
        text += *own.noise > 0 ? fmt::format(", {} noise of each", percent_text(*own.noise)) : ", without noise";
    return text;
}

}  // namespace

std::string claims_text(const Scenario& scenario, const std::vector<ClaimResult>& results) {
    std::string out;
    for (std::size_t c = 0; c < results.size(); ++c) {
        std::string word = verdict_word(results[c].verdict);
        if (results[c].verdict == ClaimVerdict::fails) word = "FAILS";
        if (results[c].verdict == ClaimVerdict::estimated) word = "estimate";
        out += fmt::format("  {:<8} {}\n           {}\n", word, scenario.claims[c].text,
                           evidence_text(scenario.claims[c], results[c]));
    }
    return out;
}

std::vector<std::string> world_lines(const Scenario& scenario) {
    const Body& body = scenario.world.body;
    const Arena& arena = scenario.world.arena;
    std::vector<std::string> lines;
    lines.push_back(
        fmt::format("{} robot{} of radius {:g} cm, wheels to {:g} cm/s, {}", scenario.all_robots(),
                    scenario.all_robots() == 1 ? "" : "s", body.radius, body.max_wheel,
                    body.noise > 0 ? fmt::format("{} noise of each", percent_text(body.noise)) : "without noise"));
    lines.push_back(fmt::format("{:g} cm by {:g} cm {}{}", arena.width, arena.height,
                                arena.walled ? "with walls" : "without walls",
                                arena.walls.empty() ? "" : fmt::format(", {} inside", arena.walls.size())));
    for (std::size_t kind = 0; kind < scenario.kind_count() && !scenario.others.empty(); ++kind) {
        const RobotKind& robots = scenario.kind_at(kind);
        lines.push_back(fmt::format("{}: {} robots by {}{}", robots.kind.text.empty() ? "first kind" : robots.kind.text,
                                    robots.robots, robots.component.text, drive_differences(scenario, kind)));
    }
    for (std::size_t kind = 0; kind < scenario.kind_count(); ++kind)
        lines.push_back(placements_line(scenario, scenario.kind_at(kind)));
    for (const Sensor& sensor : scenario.sensors) lines.push_back(sensor_line(sensor));
    for (std::size_t kind = 0; kind < scenario.kind_count(); ++kind)
        for (const Failure& failure : scenario.kind_at(kind).failures)
            lines.push_back(failure_line(scenario, scenario.kind_at(kind), failure));
    if (scenario.environment) lines.push_back(environment_line(scenario));
    lines.push_back(fmt::format("{:g} s in control steps of {:g} s, {} physics steps each", scenario.duration,
                                scenario.world.control_step, scenario.world.physics_steps));
    lines.push_back(
        fmt::format("each trial from a seed of its own, {} and on; an interval is about chance, not about what "
                    "this world leaves out",
                    scenario.seed));
    return lines;
}

std::string world_text(const Scenario& scenario) {
    return fmt::format("  {}\n", fmt::join(world_lines(scenario), "\n  "));
}

}  // namespace robochart::simulation
