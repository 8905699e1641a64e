// SPDX-License-Identifier: Apache-2.0
// Parses scenarios (scenario.hpp, docs/scenarios.md): the table of items, times, the arena and its contents.
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
    if (in_.failed()) return scenario_;
    in_.expect("scenario");
    scenario_.name = in_.name("a name for the scenario");
    in_.expect("for");
    scenario_.component = in_.qualified_name("the component that drives the robots");
    whole_ = scenario_.name.span;
    in_.expect("{");
    while (!in_.failed() && !in_.at("}")) item();
    in_.expect("}");
    if (!in_.failed() && !in_.at_end()) in_.fail("the end of the file");
    if (!in_.failed()) check();
    return scenario_;
}

const std::array<ScenarioReader::ItemRow, 28>& ScenarioReader::items() {
    static constexpr std::array<ItemRow, 28> table{{
        {"model", true, &ScenarioReader::model},        {"step", true, &ScenarioReader::step},
        {"physics", true, &ScenarioReader::physics},    {"unit", true, &ScenarioReader::time_unit},
        {"duration", true, &ScenarioReader::duration},  {"trials", true, &ScenarioReader::trials},
        {"seed", true, &ScenarioReader::seed},          {"arena", true, &ScenarioReader::arena},
        {"wall", false, &ScenarioReader::wall},         {"light", false, &ScenarioReader::light},
        {"robots", false, &ScenarioReader::robots},     {"environment", true, &ScenarioReader::environment},
        {"sensor", false, &ScenarioReader::sensor},     {"actuator", false, &ScenarioReader::actuator},
        {"feed", false, &ScenarioReader::feed},         {"drive", false, &ScenarioReader::drive},
        {"stimulus", false, &ScenarioReader::stimulus}, {"measure", false, &ScenarioReader::measure},
        {"accept", false, &ScenarioReader::accept},     {"pictures", true, &ScenarioReader::pictures},
        {"record", true, &ScenarioReader::record},      {"vary", false, &ScenarioReader::vary},
        {"estimate", false, &ScenarioReader::estimate}, {"failure", false, &ScenarioReader::failure},
        {"obstacle", false, &ScenarioReader::obstacle}, {"obstacles", false, &ScenarioReader::obstacles},
        {"abstract", true, &ScenarioReader::abstract},  {"ignore", false, &ScenarioReader::ignore},
    }};
    return table;
}

void ScenarioReader::item() {
    const auto* row = std::find_if(items().begin(), items().end(), [&](const ItemRow& r) { return in_.at(r.word); });
    if (row == items().end()) {
        std::vector<std::string> words;
        for (const ItemRow& each : items()) words.emplace_back(each.word);
        return in_.fail("an item of a scenario or '}'", words);
    }
    const diagnostics::Span span = in_.token().span;
    in_.take(row->word);
    if (row->once && !said_.emplace(row->word, span).second)
        in_.report(rules::said_twice, span, {fmt::format("'{}'", row->word)});
    (this->*row->read)();
}

void ScenarioReader::model() {
    scenario_.model = in_.quoted("the path of the model in quotes");
}

void ScenarioReader::step() {
    scenario_.world.control_step = in_.positive(Dimension::time, "the control step");
}

void ScenarioReader::physics() {
    physics_ = in_.positive(Dimension::time, "the physics step");
}

void ScenarioReader::time_unit() {
    scenario_.time_unit = in_.positive(Dimension::time, "the time unit");
}

void ScenarioReader::duration() {
    scenario_.duration = in_.positive(Dimension::time, "the duration");
}

void ScenarioReader::trials() {
    scenario_.trials = static_cast<std::uint32_t>(in_.count(1, most_trials, "the number of trials"));
}

void ScenarioReader::seed() {
    scenario_.seed = in_.count(0, 1'000'000'000, "the seed");
}

void ScenarioReader::record() {
    scenario_.record = in_.positive(Dimension::time, "the time between records");
}

void ScenarioReader::arena() {
    if (in_.take("square")) {
        scenario_.arena_area = area_per_robot();
    } else {
        scenario_.world.arena.width = in_.positive(Dimension::length, "the arena's width");
        in_.expect("by");
        scenario_.world.arena.height = in_.positive(Dimension::length, "the arena's height");
    }
    scenario_.world.arena.walled = !in_.take("open");
}

double ScenarioReader::area_per_robot() {
    in_.expect("with");
    const double area = in_.positive(Dimension::area, "the area of a robot");
    in_.expect("per");
    in_.expect("robot");
    return area;
}

void ScenarioReader::wall() {
    const diagnostics::Span begin = in_.token().span;
    const Vector from = in_.point("a point");
    in_.expect("to");
    const Vector to = in_.point("a point");
    scenario_.world.arena.walls.push_back({from, to});
    inside_.push_back({from, "the wall", diagnostics::join(begin, in_.last_span())});
    inside_.push_back({to, "the wall", diagnostics::join(begin, in_.last_span())});
}

void ScenarioReader::light() {
    Light light;
    light.name = new_name("a name for the light");
    in_.expect("at");
    light.span = in_.token().span;
    light.at = light.to = in_.point("a point");
    if (in_.take("moving")) {
        in_.expect("to");
        light.to = in_.point("a point");
        inside_.push_back({light.to, "the end of the light's way", in_.last_span()});
        in_.expect("at");
        light.speed = in_.positive(Dimension::speed, "the speed of the light");
    }
    light.span = diagnostics::join(light.span, in_.last_span());
    inside_.push_back({light.at, "the light", light.span});
    scenario_.lights.push_back(light);
}

Name ScenarioReader::new_name(std::string_view what) {
    Name name = in_.name(what);
    if (!names_.emplace(name.text, name.span).second)
        in_.report(rules::said_twice, name.span, {fmt::format("the name '{}'", name.text)});
    return name;
}

Region ScenarioReader::region() {
    const Vector a = in_.point("a point");
    in_.expect("to");
    const Vector b = in_.point("a point");
    return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

void ScenarioReader::place() {
    Placement placement;
    const diagnostics::Span begin = in_.last_span();
    using Kind = Placement::Kind;
    if (in_.take("linked")) {
        placement.kind = Kind::linked;
        in_.expect("around");
        placement.pose.at = in_.point("a point");
        in_.expect("within");
        placement.link = in_.positive(Dimension::length, "how far linked robots are from each other");
    } else if (!in_.take("random")) {
        in_.expect("at");
        placement.pose.at = in_.point("a point");
        in_.expect("heading");
        placement.pose.heading = in_.quantity(Dimension::angle, "a heading").value;
    } else if (in_.take("around")) {
        placement.kind = Kind::square;
        placement.pose.at = in_.point("a point");
        placement.area = area_per_robot();
    } else {
        in_.expect("in");
        placement.kind = in_.take("arena") ? Kind::arena : Kind::region;
        if (placement.kind == Kind::region) placement.region = region();
    }
    placement.span = diagnostics::join(begin, in_.last_span());
    const auto keep_inside = [&](Vector at) { inside_.push_back({at, "the place of robots", placement.span}); };
    if (placement.kind == Kind::region) {
        keep_inside(placement.region.low);
        keep_inside(placement.region.high);
    } else {
        keep_inside(placement.pose.at);
    }
    kind_->placements.push_back(placement);
}

void ScenarioReader::pictures() {
    in_.expect("at");
    do {
        scenario_.pictures.push_back(in_.not_negative(Dimension::time, "the time of a picture"));
        times_.push_back({scenario_.pictures.back(), in_.last_span()});
    } while (in_.take(","));
}

}  // namespace robochart::simulation
