// SPDX-License-Identifier: Apache-2.0
// Parses the basic items of scenarios (scenario.hpp, docs/scenarios.md): times, the arena and its contents. Contains
// the table of all items.
#include "simulation/scenario/scenario_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "simulation/scenario/rules.hpp"

namespace robochart::simulation {

namespace {

constexpr std::uint64_t most_trials = 100'000;

}  // namespace

Scenario ScenarioReader::read() {
    if (in_.has_failed()) return scenario_;
    in_.expect_word("scenario");
    scenario_.name = in_.name("a name for the scenario");
    in_.expect_word("for");
    scenario_.component = in_.qualified_name("the component that drives the robots");
    whole_ = scenario_.name.span;
    in_.expect_word("{");
    while (!in_.has_failed() && !in_.at_word("}")) parse_item();
    in_.expect_word("}");
    if (!in_.has_failed() && !in_.at_end()) in_.fail_expecting("the end of the file");
    if (!in_.has_failed()) check_scenario();
    return scenario_;
}

const std::array<ScenarioReader::ItemRow, 28>& ScenarioReader::item_table() {
    static constexpr std::array<ItemRow, 28> table{{
        {"model", true, &ScenarioReader::parse_model},
        {"step", true, &ScenarioReader::parse_step},
        {"physics", true, &ScenarioReader::parse_physics},
        {"unit", true, &ScenarioReader::time_unit},
        {"duration", true, &ScenarioReader::parse_duration},
        {"trials", true, &ScenarioReader::parse_trials},
        {"seed", true, &ScenarioReader::parse_seed},
        {"arena", true, &ScenarioReader::parse_arena},
        {"wall", false, &ScenarioReader::parse_wall},
        {"light", false, &ScenarioReader::parse_light},
        {"robots", false, &ScenarioReader::parse_robots},
        {"environment", true, &ScenarioReader::parse_environment},
        {"sensor", false, &ScenarioReader::parse_sensor},
        {"actuator", false, &ScenarioReader::parse_actuator},
        {"feed", false, &ScenarioReader::parse_feed},
        {"drive", false, &ScenarioReader::parse_drive},
        {"stimulus", false, &ScenarioReader::parse_stimulus},
        {"measure", false, &ScenarioReader::parse_measure},
        {"accept", false, &ScenarioReader::accept},
        {"pictures", true, &ScenarioReader::parse_pictures},
        {"record", true, &ScenarioReader::parse_record},
        {"vary", false, &ScenarioReader::parse_variation},
        {"estimate", false, &ScenarioReader::parse_estimate},
        {"failure", false, &ScenarioReader::parse_failure},
        {"obstacle", false, &ScenarioReader::parse_obstacle},
        {"obstacles", false, &ScenarioReader::parse_drawn_obstacles},
        {"abstract", true, &ScenarioReader::parse_abstraction},
        {"ignore", false, &ScenarioReader::ignore},
    }};
    return table;
}

void ScenarioReader::parse_item() {
    const auto* row = std::ranges::find_if(item_table(), [&](const ItemRow& r) { return in_.at_word(r.word); });
    if (row == item_table().end()) {
        std::vector<std::string> words;
        for (const ItemRow& item : item_table()) words.emplace_back(item.word);
        return in_.fail_expecting("an item of a scenario or '}'", words);
    }
    const diagnostics::Span span = in_.current_token().span;
    in_.take_word(row->word);
    if (row->once && !said_.emplace(row->word, span).second)
        in_.report(rules::said_twice, span, {fmt::format("'{}'", row->word)});
    (this->*row->read)();
}

void ScenarioReader::parse_model() {
    scenario_.model = in_.read_quoted("the path of the model in quotes");
}

void ScenarioReader::parse_step() {
    scenario_.world.control_step = in_.read_positive(Dimension::time, "the control step");
}

void ScenarioReader::parse_physics() {
    physics_ = in_.read_positive(Dimension::time, "the physics step");
}

void ScenarioReader::time_unit() {
    scenario_.time_unit = in_.read_positive(Dimension::time, "the time unit");
}

void ScenarioReader::parse_duration() {
    scenario_.duration = in_.read_positive(Dimension::time, "the duration");
}

void ScenarioReader::parse_trials() {
    scenario_.trials = static_cast<std::uint32_t>(in_.read_count(1, most_trials, "the number of trials"));
}

void ScenarioReader::parse_seed() {
    scenario_.seed = in_.read_count(0, 1'000'000'000, "the seed");
}

void ScenarioReader::parse_record() {
    scenario_.record = in_.read_positive(Dimension::time, "the time between records");
}

void ScenarioReader::parse_arena() {
    if (in_.take_word("square")) {
        scenario_.arena_area = area_per_robot();
    } else {
        scenario_.world.arena.width = in_.read_positive(Dimension::length, "the arena's width");
        in_.expect_word("by");
        scenario_.world.arena.height = in_.read_positive(Dimension::length, "the arena's height");
    }
    scenario_.world.arena.walled = !in_.take_word("open");
}

double ScenarioReader::area_per_robot() {
    in_.expect_word("with");
    const double area = in_.read_positive(Dimension::area, "the area of a robot");
    in_.expect_word("per");
    in_.expect_word("robot");
    return area;
}

void ScenarioReader::parse_wall() {
    const diagnostics::Span begin = in_.current_token().span;
    const Vector from = in_.read_point("a point");
    in_.expect_word("to");
    const Vector to = in_.read_point("a point");
    scenario_.world.arena.walls.push_back({from, to});
    inside_.push_back({from, "the wall", diagnostics::join_spans(begin, in_.last_span())});
    inside_.push_back({to, "the wall", diagnostics::join_spans(begin, in_.last_span())});
}

void ScenarioReader::parse_light() {
    Light light;
    light.name = new_name("a name for the light");
    in_.expect_word("at");
    light.span = in_.current_token().span;
    light.at = light.to = in_.read_point("a point");
    if (in_.take_word("moving")) {
        in_.expect_word("to");
        light.to = in_.read_point("a point");
        inside_.push_back({light.to, "the end of the light's way", in_.last_span()});
        in_.expect_word("at");
        light.speed = in_.read_positive(Dimension::speed, "the speed of the light");
    }
    light.span = diagnostics::join_spans(light.span, in_.last_span());
    inside_.push_back({light.at, "the light", light.span});
    scenario_.lights.push_back(light);
}

Name ScenarioReader::new_name(std::string_view what) {
    Name name = in_.name(what);
    if (!names_.emplace(name.text, name.span).second)
        in_.report(rules::said_twice, name.span, {fmt::format("the name '{}'", name.text)});
    return name;
}

Region ScenarioReader::parse_region() {
    const Vector a = in_.read_point("a point");
    in_.expect_word("to");
    const Vector b = in_.read_point("a point");
    return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

void ScenarioReader::parse_placement() {
    Placement placement;
    const diagnostics::Span begin = in_.last_span();
    using Kind = Placement::Kind;
    if (in_.take_word("linked")) {
        placement.kind = Kind::linked;
        in_.expect_word("around");
        placement.pose.at = in_.read_point("a point");
        in_.expect_word("within");
        placement.link = in_.read_positive(Dimension::length, "the distance of linked robots");
    } else if (!in_.take_word("random")) {
        in_.expect_word("at");
        placement.pose.at = in_.read_point("a point");
        in_.expect_word("heading");
        placement.pose.heading = in_.read_quantity(Dimension::angle, "a heading").value;
    } else if (in_.take_word("around")) {
        placement.kind = Kind::square;
        placement.pose.at = in_.read_point("a point");
        placement.area = area_per_robot();
    } else {
        in_.expect_word("in");
        placement.kind = in_.take_word("arena") ? Kind::arena : Kind::region;
        if (placement.kind == Kind::region) placement.region = parse_region();
    }
    placement.span = diagnostics::join_spans(begin, in_.last_span());
    const auto keep_inside = [&](Vector at) { inside_.push_back({at, "the place of robots", placement.span}); };
    if (placement.kind == Kind::region) {
        keep_inside(placement.region.low);
        keep_inside(placement.region.high);
    } else {
        keep_inside(placement.pose.at);
    }
    kind_->placements.push_back(placement);
}

void ScenarioReader::parse_pictures() {
    in_.expect_word("at");
    do {
        scenario_.pictures.push_back(in_.not_negative(Dimension::time, "the time of a picture"));
        times_.push_back({scenario_.pictures.back(), in_.last_span()});
    } while (in_.take_word(","));
}

}  // namespace robochart::simulation
