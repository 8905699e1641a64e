// SPDX-License-Identifier: Apache-2.0
// Parses sensors and actuators in scenarios, and their connections to the controller.
#include "simulation/scenario/scenario_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/diagnostics/spelling.hpp"
#include "simulation/scenario/rules.hpp"

namespace robochart::simulation {

/// Reports an unknown name with the names that exist, and suggests the nearest of them.
void ScenarioReader::unknown_part(const std::string& what, const Name& name, const std::vector<std::string>& known) {
    diagnostics::Diagnostic* const finding = in_.report(rules::unknown_part, name.span, {what, name.text});
    if (finding == nullptr) return;
    const std::string meant = diagnostics::nearest_spelling(name.text, known);
    if (!meant.empty()) finding->fixes.push_back({name.span, meant, diagnostics::suggestion_verb(false)});
    if (!known.empty()) finding->notes.push_back({{}, fmt::format("there is {}", fmt::join(known, ", "))});
}

void ScenarioReader::parse_sensor() {
    Sensor sensor;
    sensor.name = new_name("a name for the sensor");
    in_.expect_word("is");
    const Name kind = in_.name("a kind of sensor");
    const auto known = sensor_kind(kind.text);
    if (!known && !in_.has_failed()) {
        std::vector<std::string> kinds;
        for (const SensorName& sensor_name : sensor_names()) kinds.emplace_back(sensor_name.name);
        unknown_part("kind of sensor", kind, kinds);
        unknown_sensors_.push_back(sensor.name.text);
    }
    sensor.kind = known.value_or(SensorKind::line_of_sight);
    if (in_.take_word("{")) {
        while (!in_.has_failed() && !in_.at_word("}")) parse_option(sensor, known.has_value());
        in_.expect_word("}");
    }
    if ((known == SensorKind::light || known == SensorKind::ground) && sensor.source.text.empty())
        in_.report(rules::missing, sensor.name.span,
                   {fmt::format("the light that '{}' senses (source NAME)", sensor.name.text)});
    if (known) scenario_.sensors.push_back(sensor);
}

void ScenarioReader::parse_option(Sensor& sensor, bool known) {
    const auto is = [&](SensorKind kind, std::string_view word) {
        return (!known || sensor.kind == kind) && in_.take_word(word);
    };
    const bool detects = !known || can_err(sensor.kind);
    const auto sensors = [&] { return static_cast<std::uint32_t>(in_.read_count(1, 1024, "the number of sensors")); };
    if (in_.at_word("range") && sensor.kind != SensorKind::light && sensor.kind != SensorKind::ground) {
        in_.take_word("range");
        const double range = in_.read_positive(Dimension::length, "the range");
        sensor.sight_range = sensor.range_and_bearing.range = sensor.proximity.range = range;
    } else if (detects && in_.take_word("false_negative"))
        sensor.false_negative = in_.not_negative(Dimension::share, "the probability of a false negative");
    else if (detects && in_.take_word("false_positive"))
        sensor.false_positive = in_.not_negative(Dimension::share, "the probability of a false positive");
    else if (detects && in_.take_word("error"))
        sensor.false_negative = sensor.false_positive = in_.not_negative(Dimension::share, "the error");
    else if (is(SensorKind::range_and_bearing, "message"))
        sensor.message = in_.name("a shared variable of the controller");
    else if (is(SensorKind::range_and_bearing, "transparent"))
        sensor.range_and_bearing.occlusion = false;
    else if (is(SensorKind::range_and_bearing, "noise"))
        sensor.range_and_bearing.noise = in_.not_negative(Dimension::length, "the noise of the range");
    else if (is(SensorKind::range_and_bearing, "loss"))
        sensor.range_and_bearing.loss = in_.not_negative(Dimension::share, "the loss of messages");
    else if (is(SensorKind::light, "source") || is(SensorKind::ground, "source"))
        sensor.source = in_.name("the name of a light");
    else if (is(SensorKind::light, "leak"))
        sensor.light_ring.leak = in_.not_negative(Dimension::share, "the leak");
    else if (is(SensorKind::light, "sensors"))
        sensor.light_ring.sensors = sensors();
    else if (is(SensorKind::proximity, "sensors"))
        sensor.proximity.sensors = sensors();
    else
        in_.fail_expecting("an option of the sensor or '}'");
}

void ScenarioReader::parse_actuator() {
    Actuator actuator{new_name("a name for the actuator")};
    in_.expect_word("is");
    const Name kind = in_.name("a kind of actuator");
    if (!in_.has_failed() && kind.text != "differential_drive")
        unknown_part("kind of actuator", kind, {"differential_drive"});
    scenario_.actuators.push_back(actuator);
}

void ScenarioReader::parse_feed() {
    Feed feed;
    feed.target = in_.qualified_name("the event or variable that is fed");
    in_.expect_word("with");
    feed.part = in_.name("a sensor or actuator");
    in_.expect_word(".");
    const Name reading = in_.name("a reading");
    feed.span = diagnostics::join_spans(feed.part.span, reading.span);
    const ReadingRow* row = find_reading(feed, reading);
    if (row == nullptr) return skip_feed();
    feed.reading = row->reading;
    feed.carries = row->carries;
    if (row->argument) parse_argument(feed, *row);
    if (row->reading == Reading::message && in_sensor_without_message(feed))
        in_.report(rules::missing, feed.span,
                   {fmt::format("the variable that '{}' sends (message VARIABLE)", feed.part.text)});
    if (row->carries == Carries::real) {
        in_.expect_word("in");
        feed.factor = in_.read_unit(row->result, fmt::format("'{}'", reading.text));
    }
    if (in_.take_word("on")) feed.on = in_.name("an operation");
    kind_->feeds.push_back(feed);
}

void ScenarioReader::skip_feed() {
    if (in_.take_word("(")) {
        while (!in_.has_failed() && !in_.at_word(")") && !in_.at_end() && !in_.at_word("}")) skip_word();
        in_.expect_word(")");
    }
    if (in_.take_word("in")) (void)in_.name("a unit");
    if (in_.take_word("/")) (void)in_.name("a unit");
    if (in_.take_word("on")) (void)in_.name("an operation");
}

void ScenarioReader::skip_word() {
    const std::string word(in_.current_token().text);
    in_.take_word(word);
}

const ReadingRow* ScenarioReader::find_reading(const Feed& feed, const Name& reading) {
    if (in_.has_failed()) return nullptr;
    const auto sensor =
        std::ranges::find_if(scenario_.sensors, [&](const Sensor& s) { return s.name.text == feed.part.text; });
    const bool is_sensor = sensor != scenario_.sensors.end();
    const bool is_actuator = is_actuator_name(feed.part.text);
    const bool reported = std::ranges::find(unknown_sensors_, feed.part.text) != unknown_sensors_.end();
    if (!is_sensor && !is_actuator) {
        std::vector<std::string> known;
        for (const Sensor& declared : scenario_.sensors) known.push_back(declared.name.text);
        if (!reported) unknown_part("sensor", feed.part, known);
        return nullptr;
    }
    const ReadingRow* row = is_sensor ? reading_of(sensor->kind, reading.text) : reading_of_actuator(reading.text);
    if (row == nullptr) {
        std::vector<std::string> known;
        for (const ReadingRow& candidate : reading_table())
            if (is_sensor ? candidate.sensor == sensor->kind : !candidate.sensor) known.emplace_back(candidate.name);
        unknown_part(fmt::format("reading of '{}' named", feed.part.text), reading, known);
    }
    return row;
}

bool ScenarioReader::in_sensor_without_message(const Feed& feed) const {
    return std::ranges::any_of(scenario_.sensors, [&](const Sensor& sensor) {
        return sensor.name.text == feed.part.text && sensor.message.text.empty();
    });
}

bool ScenarioReader::is_actuator_name(const std::string& name) const {
    return std::ranges::any_of(scenario_.actuators, [&](const Actuator& a) { return a.name.text == name; });
}

void ScenarioReader::parse_argument(Feed& feed, const ReadingRow& row) {
    in_.expect_word("(");
    Argument argument;
    if (in_.at_number()) {
        argument.literal = in_.read_quantity(*row.argument, fmt::format("'{}'", row.name));
    } else {
        argument.variable = in_.name("a quantity or a variable");
        if (*row.argument != Dimension::number) {
            in_.expect_word("in");
            argument.factor = in_.read_unit(*row.argument, fmt::format("'{}'", row.name));
        }
    }
    in_.expect_word(")");
    feed.argument = argument;
}

void ScenarioReader::parse_drive() {
    Drive drive;
    drive.actuator = in_.name("an actuator");
    if (!in_.has_failed() && !is_actuator_name(drive.actuator.text)) {
        std::vector<std::string> known;
        for (const Actuator& actuator : scenario_.actuators) known.push_back(actuator.name.text);
        unknown_part("actuator", drive.actuator, known);
    }
    in_.expect_word("by");
    drive.span = in_.current_token().span;
    if (in_.take_word("speeds"))
        parse_speeds(drive);
    else if (in_.take_word("forward"))
        parse_forward(drive);
    else if (in_.take_word("turn"))
        parse_turn(drive);
    else if (in_.take_word("stop"))
        drive.motion = Motion::stop;
    else if (in_.take_word("wander"))
        parse_forward(drive), drive.motion = Motion::wander;
    else if (in_.take_word("seek"))
        parse_seek(drive);
    else
        return in_.fail_expecting("'speeds', 'forward', 'turn', 'wander', 'seek' or 'stop'");
    drive.span = diagnostics::join_spans(drive.span, in_.last_span());
    if (drive.motion != Motion::speeds) {
        in_.expect_word("on");
        drive.on = in_.name("an operation");
    }
    kind_->drives.push_back(drive);
}

void ScenarioReader::parse_speeds(Drive& drive) {
    drive.motion = Motion::speeds;
    in_.expect_word("(");
    drive.linear = in_.name("the variable of the forward speed");
    in_.expect_word("in");
    drive.linear_factor = in_.read_unit(Dimension::speed, "a forward speed");
    in_.expect_word(",");
    drive.angular = in_.name("the variable of the rate of turning");
    in_.expect_word("in");
    drive.angular_factor = in_.read_unit(Dimension::turn_rate, "a rate of turning");
    in_.expect_word(")");
}

void ScenarioReader::parse_forward(Drive& drive) {
    drive.motion = Motion::forward;
    in_.expect_word("(");
    drive.speed = in_.read_quantity(Dimension::speed, "'forward'").value;
    in_.expect_word(")");
}

void ScenarioReader::parse_turn(Drive& drive) {
    drive.motion = Motion::turn;
    in_.expect_word("(");
    drive.speed = in_.read_positive(Dimension::speed, "'turn'");
    in_.expect_word(",");
    drive.angular_factor = in_.read_unit(Dimension::angle, "'turn'");
    in_.expect_word(")");
}

void ScenarioReader::parse_seek(Drive& drive) {
    drive.motion = Motion::seek;
    in_.expect_word("(");
    drive.light = light_named(in_.name("the name of a light"));
    in_.expect_word(",");
    drive.speed = in_.read_positive(Dimension::speed, "'seek'");
    in_.expect_word(")");
}

Stimulus ScenarioReader::parse_raised_event() {
    Stimulus stimulus;
    stimulus.event = in_.qualified_name("an event");
    if (in_.take_word("=")) {
        if (in_.take_word("true"))
            stimulus.truth = true;
        else if (in_.take_word("false"))
            stimulus.truth = false;
        else if (!in_.at_number())
            stimulus.named =
                in_.qualified_name("a value: a number, true, false, or a literal or constant of the model");
        else
            stimulus.value = in_.read_quantity(Dimension::number, "the value of a stimulus");
    }
    return stimulus;
}

void ScenarioReader::parse_stimulus() {
    Stimulus stimulus = parse_raised_event();
    if (in_.take_word("every")) {
        stimulus.every = stimulus.at = in_.read_positive(Dimension::time, "the time between stimuli");
    } else {
        in_.expect_word("at");
        stimulus.at = in_.not_negative(Dimension::time, "the time of a stimulus");
        times_.push_back({stimulus.at, in_.last_span()});
    }
    kind_->stimuli.push_back(stimulus);
}

}  // namespace robochart::simulation
