// Reading scenarios: values in inner units, and findings at their places.
#include "simulation/scenario/scenario.hpp"
#include "simulation/scenario/read_scenario.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "diagnostics/render.hpp"
#include "tests/simulation/harness.hpp"

namespace robochart::simulation {
namespace {

using ::testing::HasSubstr;
using testing::replaced;

constexpr const char* good = R"(
scenario World for P::Roam {
	model "../elsewhere"
	step 100 ms physics 20 ms unit 0.05 s duration 2 s trials 3 seed 7
	arena 2 m by 100 cm open
	wall (0 cm, 0 cm) to (50 mm, -0.1 m)
	light lamp at (10 cm, 20 cm)
	robots 12 {
		radius 35 mm axle 5.3 cm wheel 0.128 m/s noise 5 %
		place random in (40 cm, 40 cm) to (-40 cm, -40 cm)
		place at (90 cm, 0 cm) heading 90 deg
	}
	sensor eye is line_of_sight { range 1 m }
	sensor radio is range_and_bearing { range 60 cm noise 2 cm loss 10 % transparent }
	sensor ring is light_ring { source lamp sensors 6 leak 25 % }
	sensor skin is proximity { sensors 4 range 5 cm }
	actuator motors is differential_drive
	feed a with eye.robot
	feed b with radio.away(reach in m) in deg on ask
	feed c with ring.lit(3)
	drive motors by speeds(v in m/s, w in deg/s)
	drive motors by turn(6.4 cm/s, deg) on turn
	stimulus e at 1 s
	stimulus f = true every 500 ms
	measure near is cluster(10 cm)
	measure way is distance(lamp)
	accept each first(near >= 90 %) <= 1.5 s
	accept mean way at 1 s in 10 cm to 0.2 m
	accept mean average(near) >= 50 %
	pictures at 0 s, 1 s
	record 200 ms
}
)";

struct Read {
    explicit Read(const std::string& text) {
        scenario = read_scenario(sources, sources.add("a.scenario", text), diagnostics);
    }
    [[nodiscard]] std::string findings() const {
        std::string out;
        for (const auto& d : diagnostics.sorted()) {
            const auto place = sources.position(d.span.source, d.span.begin);
            out += fmt(place) + " " + std::string(d.rule->code) + " " + d.message() + "\n";
        }
        return out;
    }
    static std::string fmt(diagnostics::Position place) {
        return std::to_string(place.line) + ":" + std::to_string(place.column);
    }
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    Scenario scenario;
};

TEST(Scenario, ReadsEveryItemIntoCentimetresSecondsRadians) {
    const Read read(good);
    ASSERT_EQ(read.findings(), "");
    const Scenario& s = read.scenario;
    EXPECT_EQ(s.component.text, "P::Roam");
    EXPECT_EQ(s.model, "../elsewhere");
    EXPECT_DOUBLE_EQ(s.world.control_step, 0.1);
    EXPECT_EQ(s.world.physics_steps, 5U);
    EXPECT_EQ(s.units_per_step, 2U);
    EXPECT_EQ(s.steps(), 20U);
    EXPECT_DOUBLE_EQ(s.world.arena.width, 200);
    EXPECT_FALSE(s.world.arena.walled);
    EXPECT_EQ(s.world.arena.walls.at(0).to, (Vector{5, -10}));
    EXPECT_DOUBLE_EQ(s.world.body.radius, 3.5);
    EXPECT_DOUBLE_EQ(s.world.body.max_wheel, 12.8);
    EXPECT_DOUBLE_EQ(s.world.body.noise, 0.05);
    EXPECT_EQ(s.placements.at(0).region->low, (Vector{-40, -40}));
    EXPECT_DOUBLE_EQ(s.placements.at(1).pose.heading, std::numbers::pi / 2);
    EXPECT_DOUBLE_EQ(s.sensors.at(1).range_and_bearing.loss, 0.1);
    EXPECT_FALSE(s.sensors.at(1).range_and_bearing.occlusion);
    EXPECT_EQ(s.sensors.at(2).light_ring.sensors, 6U);
    EXPECT_DOUBLE_EQ(s.feeds.at(1).argument->factor, 100);
    EXPECT_DOUBLE_EQ(s.feeds.at(1).factor, std::numbers::pi / 180);
    EXPECT_EQ(s.feeds.at(1).on->text, "ask");
    EXPECT_DOUBLE_EQ(s.drives.at(0).linear_factor, 100);
    EXPECT_TRUE(*s.stimuli.at(1).truth);
    EXPECT_DOUBLE_EQ(s.stimuli.at(1).every, 0.5);
    EXPECT_DOUBLE_EQ(s.bands.at(0).statistic.level, 0.9);
    EXPECT_DOUBLE_EQ(s.bands.at(1).high, 20);
    EXPECT_TRUE(std::isinf(s.bands.at(2).high));
    EXPECT_EQ(s.bands.at(2).text, "mean average(near) >= 50 %");
}

TEST(Scenario, FindingsStandAtTheirPlaces) {
    EXPECT_EQ(Read(replaced(good, "step 100 ms", "step 0 s")).findings(),
              "4:7 RC-M03 the control step must be greater than 0\n");
    EXPECT_EQ(Read(replaced(good, "is proximity", "is radar")).findings(),
              "16:17 RC-M06 there is no kind of sensor 'radar'\n");
    EXPECT_THAT(Read(replaced(good, "loss 10 %", "loss 10 cm")).findings(),
                "14:66 RC-M02 the loss of messages takes a share (%)\n");
    EXPECT_THAT(Read(replaced(good, "loss 10 %", "loss 110 %")).findings(),
                HasSubstr("RC-M03 the loss of messages is more than 100 %"));
    EXPECT_THAT(Read(replaced(good, "is differential_drive", "is legs")).findings(),
                HasSubstr("RC-M06 there is no kind of actuator 'legs'"));
    EXPECT_THAT(Read(replaced(good, "distance(lamp)", "distance(sun)")).findings(),
                HasSubstr("RC-M06 there is no light 'sun'"));
    EXPECT_THAT(Read(replaced(good, "physics 20 ms", "physics 30 ms")).findings(), HasSubstr("RC-M13"));
    EXPECT_THAT(Read(replaced(good, "pictures at 0 s, 1 s", "pictures at 3 s")).findings(),
                HasSubstr("RC-M03 3 s is after the end"));
    EXPECT_THAT(Read(replaced(good, "in 10 cm to 0.2 m", "in 10 cm to 5 cm")).findings(),
                HasSubstr("RC-M03 the band is empty"));
    EXPECT_THAT(Read(replaced(good, " open", "")).findings(), ::testing::Not(HasSubstr("outside")));
    EXPECT_THAT(Read(replaced(replaced(good, " open", ""), "(90 cm, 0 cm)", "(101 cm, 0 cm)")).findings(),
                HasSubstr("outside the arena"));
}

/// However a scenario is cut off, the reader ends with a finding.
TEST(Scenario, EveryBeginningIsRefusedWithAPlace) {
    const std::string text(good);
    for (std::size_t end = 0; end + 3 < text.size(); end += 7) {
        const Read read(text.substr(0, end));
        EXPECT_FALSE(read.diagnostics.ok()) << "cut at " << end;
    }
}

/// One word replaced by another of the scenario, everywhere: no crash, no hang, and a verdict.
TEST(ScenarioProperty, SwappedWordsDoNoHarm) {
    const std::string text(good);
    std::vector<std::string> words;
    std::string word;
    for (const char c : text) {
        if (std::isspace(static_cast<unsigned char>(c)) == 0)
            word += c;
        else if (!word.empty())
            words.push_back(std::exchange(word, ""));
    }
    Random random(11);
    for (int round = 0; round < 2000; ++round) {
        const std::size_t a = random.next() % words.size();
        std::string changed;
        for (std::size_t i = 0; i < words.size(); ++i)
            changed += (i == a ? words[random.next() % words.size()] : words[i]) + " ";
        const Read read(changed);
        if (!read.diagnostics.ok()) continue;
        EXPECT_GT(read.scenario.robots, 0U) << changed;
        EXPECT_GT(read.scenario.steps(), 0U) << changed;
    }
}

TEST(Start, RefusesWhatDoesNotFit) {
    Read read(replaced(good, "robots 12", "robots 200"));
    ASSERT_EQ(read.findings(), "");
    EXPECT_FALSE(start(read.scenario, 0, read.diagnostics));
    EXPECT_THAT(read.findings(), HasSubstr("10:3 RC-M09 199 robots of radius 3.5 cm do not fit"));
}

TEST(Start, TrialsDifferAndRepeat) {
    Read read(good);
    const auto first = start(read.scenario, 0, read.diagnostics);
    const auto again = start(read.scenario, 0, read.diagnostics);
    const auto second = start(read.scenario, 1, read.diagnostics);
    ASSERT_TRUE(first && again && second);
    ASSERT_EQ(first->size(), 12U);
    EXPECT_EQ(first->position(0), (Vector{90, 0}));
    EXPECT_EQ(first->position(5), again->position(5));
    EXPECT_NE(first->position(5), second->position(5));
}

}  // namespace
}  // namespace robochart::simulation
