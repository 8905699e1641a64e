// Reading scenarios; see scenario.hpp and docs/scenarios.md. One function an item.
#include "simulation/scenario.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "simulation/reader.hpp"
#include "simulation/readings.hpp"
#include "simulation/rules.hpp"

namespace robochart::simulation {

namespace {

constexpr std::uint64_t most_robots = 100'000;
constexpr std::uint64_t most_trials = 100'000;

class ScenarioReader {
public:
    ScenarioReader(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                   diagnostics::Diagnostics& diagnostics)
        : in_(sources, source, diagnostics), whole_{source, 0, 0} {}

    Scenario read() {
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

private:
    using Item = void (ScenarioReader::*)();
    struct ItemRow {
        std::string_view word;
        bool once;
        Item read;
    };
    static const std::array<ItemRow, 20>& items() {
        static constexpr std::array<ItemRow, 20> table{{
            {"model", true, &ScenarioReader::model},        {"step", true, &ScenarioReader::step},
            {"physics", true, &ScenarioReader::physics},    {"unit", true, &ScenarioReader::time_unit},
            {"duration", true, &ScenarioReader::duration},  {"trials", true, &ScenarioReader::trials},
            {"seed", true, &ScenarioReader::seed},          {"arena", true, &ScenarioReader::arena},
            {"wall", false, &ScenarioReader::wall},         {"light", false, &ScenarioReader::light},
            {"robots", true, &ScenarioReader::robots},      {"sensor", false, &ScenarioReader::sensor},
            {"actuator", false, &ScenarioReader::actuator}, {"feed", false, &ScenarioReader::feed},
            {"drive", false, &ScenarioReader::drive},       {"stimulus", false, &ScenarioReader::stimulus},
            {"measure", false, &ScenarioReader::measure},   {"accept", false, &ScenarioReader::accept},
            {"pictures", true, &ScenarioReader::pictures},  {"record", true, &ScenarioReader::record},
        }};
        return table;
    }

    void item() {
        const auto* row =
            std::find_if(items().begin(), items().end(), [&](const ItemRow& r) { return in_.at(r.word); });
        if (row == items().end()) return in_.fail("an item of a scenario or '}'");
        const diagnostics::Span span = in_.token().span;
        in_.take(row->word);
        if (row->once && !said_.emplace(row->word, span).second)
            in_.report(rules::said_twice, span, {fmt::format("'{}'", row->word)});
        (this->*row->read)();
    }

    void model() { scenario_.model = in_.quoted("the path of the model in quotes"); }
    void step() { scenario_.world.control_step = in_.positive(Dimension::time, "the control step"); }
    void physics() { physics_ = in_.positive(Dimension::time, "the physics step"); }
    void time_unit() { scenario_.time_unit = in_.positive(Dimension::time, "the time unit"); }
    void duration() { scenario_.duration = in_.positive(Dimension::time, "the duration"); }
    void trials() { scenario_.trials = static_cast<std::uint32_t>(in_.count(1, most_trials, "the number of trials")); }
    void seed() { scenario_.seed = in_.count(0, 1'000'000'000, "the seed"); }
    void record() { scenario_.record = in_.positive(Dimension::time, "the time between records"); }

    void arena() {
        scenario_.world.arena.width = in_.positive(Dimension::length, "the arena's width");
        in_.expect("by");
        scenario_.world.arena.height = in_.positive(Dimension::length, "the arena's height");
        scenario_.world.arena.walled = !in_.take("open");
    }

    void wall() {
        const diagnostics::Span begin = in_.token().span;
        const Vector from = in_.point("a point");
        in_.expect("to");
        const Vector to = in_.point("a point");
        scenario_.world.arena.walls.push_back({from, to});
        inside_.push_back({from, "the wall", diagnostics::join(begin, in_.last_span())});
        inside_.push_back({to, "the wall", diagnostics::join(begin, in_.last_span())});
    }

    void light() {
        Light light;
        light.name = new_name("a name for the light");
        in_.expect("at");
        light.span = in_.token().span;
        light.at = in_.point("a point");
        light.span = diagnostics::join(light.span, in_.last_span());
        inside_.push_back({light.at, "the light", light.span});
        scenario_.lights.push_back(light);
    }

    Name new_name(std::string_view what) {
        Name name = in_.name(what);
        if (!names_.emplace(name.text, name.span).second)
            in_.report(rules::said_twice, name.span, {fmt::format("the name '{}'", name.text)});
        return name;
    }

    void robots() {
        robots_span_ = in_.token().span;
        scenario_.robots = static_cast<std::uint32_t>(in_.count(1, most_robots, "the number of robots"));
        in_.expect("{");
        Body& body = scenario_.world.body;
        while (!in_.failed() && !in_.at("}")) {
            if (in_.take("radius"))
                body.radius = in_.positive(Dimension::length, "the radius");
            else if (in_.take("axle"))
                body.axle = in_.positive(Dimension::length, "the axle");
            else if (in_.take("wheel"))
                body.max_wheel = in_.positive(Dimension::speed, "the speed of the wheels");
            else if (in_.take("noise"))
                body.noise = in_.not_negative(Dimension::share, "the noise of the wheels");
            else if (in_.take("place"))
                place();
            else
                in_.fail("'radius', 'axle', 'wheel', 'noise', 'place' or '}'");
        }
        in_.expect("}");
    }

    void place() {
        Placement placement;
        const diagnostics::Span begin = in_.last_span();
        if (in_.take("random")) {
            in_.expect("in");
            const Vector a = in_.point("a point");
            in_.expect("to");
            const Vector b = in_.point("a point");
            placement.region =
                Region{{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
        } else {
            in_.expect("at");
            placement.pose.at = in_.point("a point");
            in_.expect("heading");
            placement.pose.heading = in_.quantity(Dimension::angle, "a heading").value;
        }
        placement.span = diagnostics::join(begin, in_.last_span());
        const auto keep_inside = [&](Vector at) { inside_.push_back({at, "the place of robots", placement.span}); };
        if (placement.region) {
            keep_inside(placement.region->low);
            keep_inside(placement.region->high);
        } else {
            keep_inside(placement.pose.at);
        }
        scenario_.placements.push_back(placement);
    }

    void sensor() {
        Sensor sensor;
        sensor.name = new_name("a name for the sensor");
        in_.expect("is");
        const Name kind = in_.name("a kind of sensor");
        const auto known = sensor_kind(kind.text);
        if (!known && !in_.failed()) {
            in_.report(rules::unknown_part, kind.span, {"kind of sensor", kind.text});
            unknown_sensors_.push_back(sensor.name.text);
        }
        sensor.kind = known.value_or(SensorKind::line_of_sight);
        if (in_.take("{")) {
            while (!in_.failed() && !in_.at("}")) option(sensor, known.has_value());
            in_.expect("}");
        }
        if (known == SensorKind::light && sensor.source.text.empty())
            in_.report(rules::missing, sensor.name.span,
                       {fmt::format("which light '{}' senses (source NAME)", sensor.name.text)});
        if (known) scenario_.sensors.push_back(sensor);
    }

    void option(Sensor& sensor, bool known) {
        const auto is = [&](SensorKind kind, std::string_view word) {
            return (!known || sensor.kind == kind) && in_.take(word);
        };
        const auto sensors = [&] { return static_cast<std::uint32_t>(in_.count(1, 1024, "the number of sensors")); };
        if (in_.at("range") && sensor.kind != SensorKind::light) {
            in_.take("range");
            const double range = in_.positive(Dimension::length, "the range");
            sensor.sight_range = sensor.range_and_bearing.range = sensor.proximity.range = range;
        } else if (is(SensorKind::range_and_bearing, "transparent"))
            sensor.range_and_bearing.occlusion = false;
        else if (is(SensorKind::range_and_bearing, "noise"))
            sensor.range_and_bearing.noise = in_.not_negative(Dimension::length, "the noise of the range");
        else if (is(SensorKind::range_and_bearing, "loss"))
            sensor.range_and_bearing.loss = in_.not_negative(Dimension::share, "the loss of messages");
        else if (is(SensorKind::light, "source"))
            sensor.source = in_.name("the name of a light");
        else if (is(SensorKind::light, "leak"))
            sensor.light_ring.leak = in_.not_negative(Dimension::share, "the leak");
        else if (is(SensorKind::light, "sensors"))
            sensor.light_ring.sensors = sensors();
        else if (is(SensorKind::proximity, "sensors"))
            sensor.proximity.sensors = sensors();
        else
            in_.fail("an option of the sensor or '}'");
    }

    void actuator() {
        Actuator actuator{new_name("a name for the actuator")};
        in_.expect("is");
        const Name kind = in_.name("a kind of actuator");
        if (!in_.failed() && kind.text != "differential_drive")
            in_.report(rules::unknown_part, kind.span, {"kind of actuator", kind.text});
        scenario_.actuators.push_back(actuator);
    }

    void feed() {
        Feed feed;
        feed.target = in_.qualified_name("the event or variable that is fed");
        in_.expect("with");
        feed.part = in_.name("a sensor or actuator");
        in_.expect(".");
        const Name reading = in_.name("a reading");
        feed.span = diagnostics::join(feed.part.span, reading.span);
        const ReadingRow* row = find_reading(feed, reading);
        if (row == nullptr) return skip_feed();
        feed.reading = row->reading;
        feed.carries = row->carries;
        if (row->argument) argument(feed, *row);
        if (row->carries == Carries::real) {
            in_.expect("in");
            feed.factor = in_.unit(row->result, fmt::format("'{}'", reading.text));
        }
        if (in_.take("on")) feed.on = in_.name("an operation");
        scenario_.feeds.push_back(feed);
    }

    /// After an unknown sensor or reading the rest of the item is passed over, for its form is not known.
    void skip_feed() {
        if (in_.take("(")) {
            while (!in_.failed() && !in_.at(")") && !in_.at_end() && !in_.at("}")) skip_word();
            in_.expect(")");
        }
        if (in_.take("in")) (void)in_.name("a unit");
        if (in_.take("/")) (void)in_.name("a unit");
        if (in_.take("on")) (void)in_.name("an operation");
    }

    void skip_word() {
        const std::string word(in_.token().text);
        in_.take(word);
    }

    const ReadingRow* find_reading(const Feed& feed, const Name& reading) {
        if (in_.failed()) return nullptr;
        const auto sensor = std::find_if(scenario_.sensors.begin(), scenario_.sensors.end(),
                                         [&](const Sensor& s) { return s.name.text == feed.part.text; });
        const bool is_sensor = sensor != scenario_.sensors.end();
        const bool is_actuator = is_actuator_name(feed.part.text);
        const bool reported =
            std::find(unknown_sensors_.begin(), unknown_sensors_.end(), feed.part.text) != unknown_sensors_.end();
        if (!is_sensor && !is_actuator) {
            if (!reported) in_.report(rules::unknown_part, feed.part.span, {"sensor", feed.part.text});
            return nullptr;
        }
        const ReadingRow* row = is_sensor ? reading_of(sensor->kind, reading.text) : reading_of_actuator(reading.text);
        if (row == nullptr)
            in_.report(rules::unknown_part, reading.span,
                       {fmt::format("reading of '{}' named", feed.part.text), reading.text});
        return row;
    }

    [[nodiscard]] bool is_actuator_name(const std::string& name) const {
        return std::any_of(scenario_.actuators.begin(), scenario_.actuators.end(),
                           [&](const Actuator& a) { return a.name.text == name; });
    }

    void argument(Feed& feed, const ReadingRow& row) {
        in_.expect("(");
        Argument argument;
        if (in_.at_number()) {
            argument.literal = in_.quantity(*row.argument, fmt::format("'{}'", row.name));
        } else {
            argument.variable = in_.name("a quantity or a variable");
            if (*row.argument != Dimension::number) {
                in_.expect("in");
                argument.factor = in_.unit(*row.argument, fmt::format("'{}'", row.name));
            }
        }
        in_.expect(")");
        feed.argument = argument;
    }

    void drive() {
        Drive drive;
        drive.actuator = in_.name("an actuator");
        if (!in_.failed() && !is_actuator_name(drive.actuator.text))
            in_.report(rules::unknown_part, drive.actuator.span, {"actuator", drive.actuator.text});
        in_.expect("by");
        drive.span = in_.token().span;
        if (in_.take("speeds"))
            speeds(drive);
        else if (in_.take("forward"))
            forward(drive);
        else if (in_.take("turn"))
            turn(drive);
        else if (in_.take("stop"))
            drive.motion = Motion::stop;
        else
            return in_.fail("'speeds', 'forward', 'turn' or 'stop'");
        drive.span = diagnostics::join(drive.span, in_.last_span());
        if (drive.motion != Motion::speeds) {
            in_.expect("on");
            drive.on = in_.name("an operation");
        }
        scenario_.drives.push_back(drive);
    }

    void speeds(Drive& drive) {
        drive.motion = Motion::speeds;
        in_.expect("(");
        drive.linear = in_.name("the variable of the forward speed");
        in_.expect("in");
        drive.linear_factor = in_.unit(Dimension::speed, "a forward speed");
        in_.expect(",");
        drive.angular = in_.name("the variable of the rate of turning");
        in_.expect("in");
        drive.angular_factor = in_.unit(Dimension::turn_rate, "a rate of turning");
        in_.expect(")");
    }

    void forward(Drive& drive) {
        drive.motion = Motion::forward;
        in_.expect("(");
        drive.speed = in_.quantity(Dimension::speed, "'forward'").value;
        in_.expect(")");
    }

    /// `turn(12.8 cm/s, deg)`: wheel speed, unit of the operation's argument.
    void turn(Drive& drive) {
        drive.motion = Motion::turn;
        in_.expect("(");
        drive.speed = in_.positive(Dimension::speed, "'turn'");
        in_.expect(",");
        drive.angular_factor = in_.unit(Dimension::angle, "'turn'");
        in_.expect(")");
    }

    void stimulus() {
        Stimulus stimulus;
        stimulus.event = in_.qualified_name("an event");
        if (in_.take("=")) {
            if (in_.take("true"))
                stimulus.truth = true;
            else if (in_.take("false"))
                stimulus.truth = false;
            else
                stimulus.value = in_.quantity(Dimension::number, "the value of a stimulus");
        }
        if (in_.take("every")) {
            stimulus.every = stimulus.at = in_.positive(Dimension::time, "the time between stimuli");
        } else {
            in_.expect("at");
            stimulus.at = in_.not_negative(Dimension::time, "the time of a stimulus");
            times_.push_back({stimulus.at, in_.last_span()});
        }
        scenario_.stimuli.push_back(stimulus);
    }

    void measure() {
        Measure measure;
        measure.name = new_name("a name for the measure");
        in_.expect("is");
        const Name kind = in_.name("a kind of measure");
        if (in_.failed()) return;
        if (kind.text == "cluster") {
            measure.kind = MeasureKind::cluster;
            in_.expect("(");
            measure.link = in_.positive(Dimension::length, "the length of a link");
            in_.expect(")");
        } else if (kind.text == "distance") {
            measure.kind = MeasureKind::distance;
            in_.expect("(");
            measure.light = light_named(in_.name("the name of a light"));
            in_.expect(")");
        } else if (kind.text == "spread") {
            measure.kind = MeasureKind::spread;
        } else if (kind.text == "second_moment") {
            measure.kind = MeasureKind::second_moment;
        } else {
            in_.report(rules::unknown_part, kind.span, {"kind of measure", kind.text});
            return in_.fail("'cluster', 'distance', 'spread' or 'second_moment'");
        }
        scenario_.measures.push_back(measure);
    }

    std::size_t light_named(const Name& name) {
        for (std::size_t i = 0; i < scenario_.lights.size(); ++i)
            if (scenario_.lights[i].name.text == name.text) return i;
        in_.report(rules::unknown_part, name.span, {"light", name.text});
        return 0;
    }

    [[nodiscard]] Dimension dimension_of(std::size_t measure) const {
        if (measure >= scenario_.measures.size()) return Dimension::number;
        const MeasureKind kind = scenario_.measures[measure].kind;
        if (kind == MeasureKind::cluster) return Dimension::share;
        return kind == MeasureKind::second_moment ? Dimension::number : Dimension::length;
    }

    std::size_t measure_named() {
        const Name name = in_.name("a measure");
        for (std::size_t i = 0; i < scenario_.measures.size(); ++i)
            if (scenario_.measures[i].name.text == name.text) return i;
        in_.report(rules::unknown_part, name.span, {"measure", name.text});
        return scenario_.measures.size();
    }

    void accept() {
        Band band;
        band.each = in_.take("each");
        if (!band.each) in_.expect("mean");
        const diagnostics::Span begin = in_.token().span;
        const Dimension dimension = statistic(band.statistic);
        if (in_.take("<=")) {
            band.low = -INFINITY;
            band.high = in_.quantity(dimension, "this measure").value;
        } else if (in_.take(">=")) {
            band.low = in_.quantity(dimension, "this measure").value;
            band.high = INFINITY;
        } else {
            in_.expect("in");
            band.low = in_.quantity(dimension, "this measure").value;
            in_.expect("to");
            band.high = in_.quantity(dimension, "this measure").value;
        }
        band.span = diagnostics::join(begin, in_.last_span());
        if (band.low > band.high) in_.report(rules::out_of_range, band.span, {"the band is empty"});
        band.text = fmt::format("{} {}", band.each ? "each" : "mean", in_.failed() ? "" : in_.text_since(begin));
        if (band.statistic.measure < scenario_.measures.size()) scenario_.bands.push_back(band);
    }

    /// `first(M >= Q)`, `average(M)`, `M at TIME`, `M`; what it is measured in.
    Dimension statistic(Statistic& statistic) {
        if (in_.take("first")) {
            statistic.kind = StatisticKind::first_time;
            in_.expect("(");
            statistic.measure = measure_named();
            statistic.at_least = in_.take(">=");
            if (!statistic.at_least) in_.expect("<=");
            statistic.level = in_.quantity(dimension_of(statistic.measure), "this measure").value;
            in_.expect(")");
            return Dimension::time;
        }
        if (in_.take("average")) {
            statistic.kind = StatisticKind::average;
            in_.expect("(");
            statistic.measure = measure_named();
            in_.expect(")");
            return dimension_of(statistic.measure);
        }
        statistic.measure = measure_named();
        if (in_.take("at")) {
            statistic.kind = StatisticKind::at_time;
            statistic.time = in_.not_negative(Dimension::time, "the time of a measure");
            times_.push_back({statistic.time, in_.last_span()});
        }
        return dimension_of(statistic.measure);
    }

    void pictures() {
        in_.expect("at");
        do {
            scenario_.pictures.push_back(in_.not_negative(Dimension::time, "the time of a picture"));
            times_.push_back({scenario_.pictures.back(), in_.last_span()});
        } while (in_.take(","));
    }

    // ------------------------------------------------------------ what belongs together

    void check() {
        for (const auto& [word, what] :
             {std::pair("step", "the control step"), std::pair("physics", "the physics step"),
              std::pair("unit", "how long a time unit of the model is"), std::pair("duration", "the duration"),
              std::pair("arena", "the arena"), std::pair("robots", "how many robots there are")})
            if (!said_.contains(word)) in_.report(rules::missing, whole_, {what});
        if (said_.contains("robots") && scenario_.placements.empty())
            in_.report(rules::missing, robots_span_, {"where the robots are placed"});
        check_steps();
        check_places();
        check_lights();
        for (const auto& [time, span] : times_)
            if (said_.contains("duration") && time > scenario_.duration)
                in_.report(rules::out_of_range, span,
                           {fmt::format("{} s is after the end, {} s", time, scenario_.duration)});
    }

    [[nodiscard]] diagnostics::Span said(std::string_view word) const {
        const auto found = said_.find(word);
        return found == said_.end() ? whole_ : found->second;
    }

    /// How often `part` goes into `whole`; reports if it does not.
    std::uint64_t divide(double whole, const char* whole_name, double part, const char* part_name,
                         std::string_view word) {
        const double times = std::round(whole / part);
        if (times < 1 || std::abs(times * part - whole) > 1e-9 * whole || times > 1e6) {
            in_.report(rules::uneven_steps, said(word), {whole_name, part_name});
            return 1;
        }
        return static_cast<std::uint64_t>(times);
    }

    void check_steps() {
        const double step = scenario_.world.control_step;
        if (!said_.contains("step") || step <= 0) return;
        if (physics_ > 0)
            scenario_.world.physics_steps =
                static_cast<std::uint32_t>(divide(step, "the control step", physics_, "the physics step", "physics"));
        if (scenario_.time_unit > 0)
            scenario_.units_per_step = static_cast<std::uint32_t>(
                divide(step, "the control step", scenario_.time_unit, "the time unit", "unit"));
        if (scenario_.duration > 0 && scenario_.duration < step)
            in_.report(rules::out_of_range, said("duration"), {"the duration is shorter than a control step"});
        if (scenario_.duration / step > 1e8)
            in_.report(rules::out_of_range, said("duration"), {"the duration is more than 100,000,000 control steps"});
    }

    void check_places() {
        const Arena& arena = scenario_.world.arena;
        if (!said_.contains("arena")) return;
        for (const Inside& place : inside_)
            if (arena.walled && (std::abs(place.at.x) > arena.width / 2 || std::abs(place.at.y) > arena.height / 2))
                in_.report(rules::out_of_range, place.span, {fmt::format("{} lies outside the arena", place.what)});
    }

    void check_lights() {
        for (const Sensor& sensor : scenario_.sensors)
            if (sensor.kind == SensorKind::light && !sensor.source.text.empty()) (void)light_named(sensor.source);
    }

    struct Inside {
        Vector at;
        const char* what;
        diagnostics::Span span;
    };

    Reader in_;
    Scenario scenario_;
    diagnostics::Span whole_;
    diagnostics::Span robots_span_;
    double physics_ = 0;
    std::map<std::string, diagnostics::Span, std::less<>> said_;
    std::map<std::string, diagnostics::Span> names_;
    std::vector<std::string> unknown_sensors_;
    std::vector<Inside> inside_;
    std::vector<std::pair<double, diagnostics::Span>> times_;
};

}  // namespace

std::uint64_t Scenario::steps() const {
    return static_cast<std::uint64_t>(std::llround(duration / world.control_step));
}

Scenario read_scenario(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                       diagnostics::Diagnostics& diagnostics) {
    return ScenarioReader(sources, source, diagnostics).read();
}

std::optional<World> start(const Scenario& scenario, std::uint32_t trial, diagnostics::Diagnostics& diagnostics) {
    World world(scenario.world, scenario.seed + trial);
    std::size_t fixed = 0;
    std::size_t regions = 0;
    for (const Placement& placement : scenario.placements) (placement.region ? regions : fixed) += 1;
    const auto refuse = [&](std::size_t robots, diagnostics::Span span) {
        diagnostics.report(rules::no_room, span,
                           {std::to_string(robots), fmt::format("{}", scenario.world.body.radius)});
        return std::nullopt;
    };
    if (fixed > scenario.robots || (regions == 0 && fixed < scenario.robots)) {
        const std::string cause = fmt::format("{} robots, but places for {}", scenario.robots, fixed);
        diagnostics.report(rules::out_of_range, scenario.placements.back().span, {cause});
        return std::nullopt;
    }
    for (const Placement& placement : scenario.placements)
        if (!placement.region) world.place(placement.pose);
    // Several regions take the robots in equal parts, the first ones one more.
    std::size_t left = scenario.robots - fixed;
    for (const Placement& placement : scenario.placements) {
        if (!placement.region) continue;
        const std::size_t here = (left + regions - 1) / regions;
        const Vector extent = placement.region->high - placement.region->low;
        const double radius = scenario.world.body.radius;
        const double cover = static_cast<double>(here) * std::numbers::pi * radius * radius;
        if (cover > 0.4 * extent.x * extent.y || !world.place_at_random(here, *placement.region))
            return refuse(here, placement.span);
        left -= here;
        --regions;
    }
    return world;
}

}  // namespace robochart::simulation
