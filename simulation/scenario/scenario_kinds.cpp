// SPDX-License-Identifier: Apache-2.0
// Parses kinds of robots in scenarios, and the controller of the environment.
#include <fmt/format.h>

#include <algorithm>

#include "simulation/scenario/rules.hpp"
#include "simulation/scenario/scenario_reader.hpp"

namespace robochart::simulation {

void ScenarioReader::parse_robots() {
    const diagnostics::Span begin = in_.current_token().span;
    RobotKind kind;
    kind.robots = static_cast<std::uint32_t>(in_.read_count(1, most_robots_, "the number of robots"));
    if (!in_.at_word("{") && !in_.at_word("for")) kind.kind = new_name("'{', or a name for these robots");
    const std::string environment = scenario_.controller_name(scenario_.kind_count());
    if (kind.kind.text == environment)
        in_.report(rules::said_twice, kind.kind.span,
                   {fmt::format("the name '{}', which the environment already has,", environment)});
    if (in_.take_word("for")) return other_kind(std::move(kind), begin);
    if (!said_.emplace("robots", begin).second)
        in_.report(rules::said_twice, begin, {"'robots' (others have a name, `for` and a component of their own)"});
    robots_span_ = begin;
    scenario_.robots = kind.robots;
    scenario_.kind = kind.kind;
    in_.expect_word("{");
    while (!in_.has_failed() && !in_.at_word("}")) robot_option();
    in_.expect_word("}");
}

bool ScenarioReader::drive_option(OwnDrive& own) {
    if (in_.take_word("axle"))
        own.axle = in_.read_positive(Dimension::length, "the axle");
    else if (in_.take_word("wheel"))
        own.max_wheel = in_.read_positive(Dimension::speed, "the speed of the wheels");
    else if (in_.take_word("noise"))
        own.noise = in_.not_negative(Dimension::share, "the noise of the wheels");
    else
        return false;
    return true;
}

void ScenarioReader::robot_option() {
    if (drive_option(scenario_.own)) {
        scenario_.world.body = scenario_.body_of(0);
        scenario_.own = {};
    } else if (in_.take_word("radius")) {
        scenario_.world.body.radius = in_.read_positive(Dimension::length, "the radius");
    } else if (in_.take_word("place")) {
        parse_placement();
    } else if (in_.take_word("const")) {
        parse_constant(scenario_);
    } else {
        in_.fail_expecting("'radius', 'axle', 'wheel', 'noise', 'place', 'const' or '}'");
    }
}

/// Reports an error, because all robots of the world have the same radius.
void ScenarioReader::other_radius() {
    const diagnostics::Span begin = in_.last_span();
    (void)in_.read_positive(Dimension::length, "the radius");
    in_.report(
        rules::out_of_range, diagnostics::join_spans(begin, in_.last_span()),
        {"robots of all kinds have the radius of the first: another kind has an 'axle', a 'wheel' and 'noise' of "
         "its own"});
}

void ScenarioReader::other_kind(RobotKind kind, diagnostics::Span begin) {
    kind.component = in_.qualified_name("the component that drives these robots");
    if (kind.kind.text.empty() && !in_.has_failed())
        in_.report(rules::missing, diagnostics::join_spans(begin, in_.last_span()),
                   {"the name of these robots (robots NUMBER NAME for COMPONENT)"});
    in_.expect_word("{");
    kind_ = &kind;
    while (!in_.has_failed() && !in_.at_word("}")) {
        if (in_.take_word("model"))
            kind.model = in_.read_quoted("the path of the model in quotes");
        else if (in_.take_word("const"))
            parse_constant(kind);
        else if (in_.take_word("radius"))
            other_radius();
        else if (drive_option(kind.own))
            continue;
        else if (in_.take_word("place"))
            parse_placement();
        else if (in_.take_word("feed"))
            parse_feed();
        else if (in_.take_word("drive"))
            parse_drive();
        else if (in_.take_word("stimulus"))
            parse_stimulus();
        else if (in_.take_word("failure"))
            parse_failure();
        else if (in_.take_word("ignore"))
            ignore();
        else
            in_.fail_expecting(
                "'model', 'const', 'axle', 'wheel', 'noise', 'place', 'feed', 'drive', 'stimulus', "
                "'failure', 'ignore' or '}'");
    }
    kind_ = &scenario_;
    in_.expect_word("}");
    if (kind.placements.empty() && !in_.has_failed())
        in_.report(rules::missing, kind.component.span, {"the places of the robots"});
    scenario_.others.push_back(std::move(kind));
}

void ScenarioReader::parse_constant(Controlled& controlled) {
    std::string text = in_.qualified_name("a constant of the model").text;
    in_.expect_word("=");
    text += in_.take_word("-") ? "=-" : "=";
    if (in_.at_number()) {
        text += in_.current_token().text;
        skip_word();
    } else {
        text += in_.qualified_name("the value of a constant").text;
    }
    controlled.constants.push_back(std::move(text));
}

/// Parses `ignore NAME, NAME ...`.
void ScenarioReader::ignore_in(Controlled& controlled) {
    do controlled.ignored.push_back(in_.name("an event or an operation of the component"));
    while (in_.take_word(","));
}

std::size_t ScenarioReader::kind_of_measure(const Name& name) {
    if (const auto found = kind_named(scenario_, name.text)) return *found;
    std::vector<std::string> known;
    for (std::size_t kind = 0; kind < scenario_.kind_count(); ++kind)
        if (!scenario_.kind_at(kind).kind.text.empty()) known.push_back(scenario_.kind_at(kind).kind.text);
    unknown_part("kind of robots", name, known);
    return 0;
}

// ---------------------------------------------------------------- the environment

void ScenarioReader::parse_environment() {
    Environment& environment = scenario_.environment.emplace();
    environment.component = in_.qualified_name("the component that acts on the world");
    in_.expect_word("{");
    while (!in_.has_failed() && !in_.at_word("}")) {
        if (in_.take_word("model"))
            environment.model = in_.read_quoted("the path of the model in quotes");
        else if (in_.take_word("const"))
            parse_constant(environment);
        else if (in_.take_word("feed"))
            world_feed();
        else if (in_.take_word("drive"))
            world_drive();
        else if (in_.take_word("stimulus"))
            world_stimulus();
        else if (in_.take_word("failure"))
            world_failure();
        else if (in_.take_word("ignore"))
            ignore_in(environment);
        else
            in_.fail_expecting("'model', 'const', 'feed', 'drive', 'stimulus', 'failure', 'ignore' or '}'");
    }
    in_.expect_word("}");
}

/// Parses `feed EVENT with MEASURE in UNIT` or `feed EVENT when CONDITION`.
void ScenarioReader::world_feed() {
    WorldFeed feed;
    feed.target = in_.qualified_name("the event that is fed");
    const diagnostics::Span begin = in_.current_token().span;
    if (in_.take_word("when")) {
        feed.condition = parse_disjunction();
        if (feed.condition->of_trial())
            in_.report(rules::wrong_instant, diagnostics::join_spans(begin, in_.last_span()),
                       {"'when' takes a condition at an instant"});
    } else {
        in_.expect_word("with");
        feed.measure = measure_named();
        const bool known = feed.measure < scenario_.measures.size();
        const Dimension dimension = dimension_of(feed.measure);
        if (!known && in_.take_word("in") && !in_.take_word("%")) (void)in_.name("a unit");
        if (known && dimension != Dimension::number) {
            in_.expect_word("in");
            feed.factor = in_.read_unit(dimension, "this measure");
        }
    }
    feed.span = diagnostics::join_spans(begin, in_.last_span());
    if (!in_.has_failed()) feed.text = in_.text_since(begin);
    // Unknown measures have been reported.
    if (feed.condition || feed.measure < scenario_.measures.size())
        scenario_.environment->feeds.push_back(std::move(feed));
}

/// Parses `drive LIGHT by switch_on`, `switch_off`, `move((X, Y), SPEED)` or `move(UNIT, SPEED)`, or `drive OBSTACLE by
/// appear` or `vanish`.
void ScenarioReader::world_drive() {
    using Kind = WorldAct::Kind;
    WorldAct act;
    const Name name = in_.name("a light or an obstacle");
    if (in_.has_failed()) return;
    const auto& obstacles = scenario_.obstacles;
    const auto obstacle =
        std::ranges::find_if(obstacles, [&](const Obstacle& candidate) { return candidate.name.text == name.text; });
    const bool is_obstacle = obstacle != obstacles.end();
    const bool is_light =
        std::ranges::any_of(scenario_.lights, [&](const Light& light) { return light.name.text == name.text; });
    if (!is_obstacle && !is_light) return unknown_subject(name);
    act.what = is_obstacle ? static_cast<std::size_t>(obstacle - obstacles.begin()) : light_named(name);
    in_.expect_word("by");
    const diagnostics::Span begin = in_.current_token().span;
    if (is_obstacle) {
        act.kind = in_.take_word("vanish") ? Kind::obstacle_vanish : Kind::obstacle_appear;
        if (act.kind == Kind::obstacle_appear && !in_.take_word("appear"))
            return in_.fail_expecting("'appear' or 'vanish'");
        return add_act(std::move(act), begin);
    }
    if (in_.take_word("switch_on")) return add_act(std::move(act), begin);
    if (in_.take_word("switch_off")) {
        act.kind = Kind::light_off;
        return add_act(std::move(act), begin);
    }
    if (!in_.take_word("move")) return in_.fail_expecting("'switch_on', 'switch_off' or 'move'");
    act.kind = Kind::light_move;
    in_.expect_word("(");
    if (in_.at_word("(")) {
        act.to = in_.read_point("a point");
        inside_.push_back({*act.to, "the end of the light's way", in_.last_span()});
    } else {
        act.factor = in_.read_unit(Dimension::length, "'move'");
    }
    in_.expect_word(",");
    act.speed = in_.read_positive(Dimension::speed, "the speed of the light");
    in_.expect_word(")");
    add_act(std::move(act), begin);
}

/// Reports an unknown subject and skips the rest of the item, because its form depends on the subject.
void ScenarioReader::unknown_subject(const Name& name) {
    std::vector<std::string> known;
    for (const Light& light : scenario_.lights) known.push_back(light.name.text);
    for (const Obstacle& obstacle : scenario_.obstacles) known.push_back(obstacle.name.text);
    unknown_part("light or obstacle", name, known);
    while (!in_.at_word("on") && !in_.at_word("}") && !in_.at_end()) skip_word();
    in_.expect_word("on");
    (void)in_.name("an operation or an output of the environment");
}

void ScenarioReader::world_stimulus() {
    WorldAct act;
    const diagnostics::Span begin = in_.current_token().span;
    act.kind = WorldAct::Kind::stimulus;
    act.stimulus = parse_raised_event();
    add_act(std::move(act), begin);
}

/// Parses `failure of KIND in N robots`.
void ScenarioReader::world_failure() {
    WorldAct act;
    const diagnostics::Span begin = in_.current_token().span;
    act.kind = WorldAct::Kind::failure;
    const auto kind = failure_kind();
    if (!kind) return;
    act.failure.kind = *kind;
    in_.expect_word("in");
    act.failure.robots = static_cast<std::uint32_t>(in_.read_count(1, most_robots_, "the number of robots that fail"));
    in_.expect_word("robots");
    add_act(std::move(act), begin);
}

void ScenarioReader::add_act(WorldAct act, diagnostics::Span begin) {
    act.span = diagnostics::join_spans(begin, in_.last_span());
    in_.expect_word("on");
    act.on = in_.name("an operation or an output of the environment");
    scenario_.environment->acts.push_back(std::move(act));
}

}  // namespace robochart::simulation
