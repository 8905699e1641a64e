// SPDX-License-Identifier: Apache-2.0
// Tests the parsing of scenarios: values in internal units, and findings at their places.
#include "simulation/scenario/scenario.hpp"
#include "simulation/scenario/read_scenario.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/diagnostics/render.hpp"
#include "simulation/scenario/scenario_words.hpp"
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
        for (const auto& d : diagnostics.sorted_findings()) {
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
    EXPECT_EQ(s.step_count(), 20U);
    EXPECT_DOUBLE_EQ(s.world.arena.width, 200);
    EXPECT_FALSE(s.world.arena.walled);
    EXPECT_EQ(s.world.arena.walls.at(0).to, (Vector{5, -10}));
    EXPECT_DOUBLE_EQ(s.world.body.radius, 3.5);
    EXPECT_DOUBLE_EQ(s.world.body.max_wheel, 12.8);
    EXPECT_DOUBLE_EQ(s.world.body.noise, 0.05);
    EXPECT_EQ(s.placements.at(0).region.low, (Vector{-40, -40}));
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
    EXPECT_DOUBLE_EQ(s.bands.at(0).statistic.condition.low, 0.9);
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

TEST(Scenario, ReadsClaims) {
    const std::string band = "accept mean average(near) >= 50 %";
    const Read read(replaced(good, band,
                             "accept probability (near >= 50 % and way <= 9 cm) stays for 0.5 s within 1.5 s "
                             ">= 95 % with confidence 99 %, indifference 2 %, at most 500 trials"));
    ASSERT_EQ(read.findings(), "");
    const Claim& claim = read.scenario.claims.at(0);
    EXPECT_EQ(claim.property.kind, Formula::Kind::within);
    EXPECT_DOUBLE_EQ(claim.property.time, 1.5);
    EXPECT_EQ(claim.property.parts.at(0).kind, Formula::Kind::stays);
    EXPECT_EQ(claim.property.parts[0].parts.at(0).kind, Formula::Kind::both);
    EXPECT_DOUBLE_EQ(claim.property.parts[0].parts[0].parts.at(1).high, 9);
    EXPECT_TRUE(claim.at_least);
    EXPECT_DOUBLE_EQ(claim.probability, 0.95);
    EXPECT_DOUBLE_EQ(claim.confidence, 0.99);
    EXPECT_DOUBLE_EQ(claim.indifference, 0.02);
    EXPECT_EQ(claim.trials, 500U);
    EXPECT_EQ(claim.text,
              "probability (near >= 50 % and way <= 9 cm) stays for 0.5 s within 1.5 s >= 95 % with "
              "confidence 99 %, indifference 2 %, at most 500 trials");
}

TEST(Scenario, FindingsInClaims) {
    const auto findings = [](const std::string& claim) {
        return Read(replaced(good, "mean average(near) >= 50 %", claim)).findings();
    };
    const std::string tail = " >= 50 % with confidence 90 %";
    EXPECT_THAT(findings("probability near >= 1 % and way <= 1 cm within 1 s" + tail),
                HasSubstr("RC-M16 'and' joins a condition at an instant and a property of a trial"));
    EXPECT_THAT(findings("probability (always near >= 1 %) within 1 s" + tail), HasSubstr("RC-M16 'within' takes"));
    EXPECT_THAT(findings("each first(near >= 1 % within 1 s) <= 1 s"), HasSubstr("RC-M16 'first' takes"));
    EXPECT_THAT(findings("probability not near >= 1 % within 1 s" + tail),
                HasSubstr("RC-M01 expected parentheses after 'not', found 'within'"));
    EXPECT_THAT(findings("probability near >= 1 % within 3 s" + tail), HasSubstr("RC-M03 3 s is after the end"));
    EXPECT_THAT(findings("probability near >= 1 % >= 50 % with confidence 100 %"),
                HasSubstr("RC-M03 the confidence is at least 50 % and less than 100 %"));
    EXPECT_THAT(findings("probability near >= 1 %" + tail + ", indifference 50 %"),
                HasSubstr("RC-M03 the probability, more or less the indifference, is not between"));
    EXPECT_THAT(findings("probability far >= 1 %" + tail), HasSubstr("RC-M06 there is no measure 'far'"));
    std::string deep = "probability ";
    for (int i = 0; i < 100'000; ++i) deep += "(";
    EXPECT_THAT(findings(deep), HasSubstr("RC-M01 expected at most 100 words"));
}

/// For every prefix of a scenario, the parser ends with a finding.
TEST(Scenario, EveryBeginningIsRefusedWithAPlace) {
    const std::string text(good);
    for (std::size_t end = 0; end + 3 < text.size(); end += 7) {
        const Read read(text.substr(0, end));
        EXPECT_FALSE(read.diagnostics.ok()) << "cut at " << end;
    }
}

/// Replaces one word by another word of the scenario. The parser must not crash or hang, and must accept or reject the
/// text.
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
        EXPECT_GT(read.scenario.step_count(), 0U) << changed;
    }
}

TEST(Start, RefusesWhatDoesNotFit) {
    Read read(replaced(good, "robots 12", "robots 200"));
    ASSERT_EQ(read.findings(), "");
    EXPECT_FALSE(start(read.scenario, 0, read.diagnostics));
    EXPECT_THAT(read.findings(), HasSubstr("10:3 RC-M09 199 robots of radius 3.5 cm do not fit"));
}

/// Four robots with 300 cm2 each start in a square with a side of 34.6 cm, in an arena with a side of 60 cm. Nine
/// robots start in a square with a side of 52.0 cm, in an arena with a side of 90 cm.
TEST(Start, SquaresGrowWithTheRobots) {
    const std::string text = R"(scenario S for M {
	step 0.1 s physics 0.1 s unit 0.1 s duration 1 s
	arena square with 0.09 m2 per robot
	robots 4 { radius 1 cm place random around (10 cm, 0 cm) with 300 cm2 per robot }
})";
    Read read(text);
    ASSERT_EQ(read.findings(), "");
    EXPECT_DOUBLE_EQ(read.scenario.world.arena.width, 60);
    for (const auto& [robots, side] : {std::pair(4U, 60.0), std::pair(9U, 90.0)}) {
        read.scenario.set_robots(robots);
        EXPECT_DOUBLE_EQ(read.scenario.world.arena.height, side);
        const auto world = start(read.scenario, 3, read.diagnostics);
        ASSERT_TRUE(world);
        ASSERT_EQ(world->size(), robots);
        const double half = std::sqrt(300.0 * robots) / 2 - 1;
        double farthest = 0;
        for (std::size_t i = 0; i < robots; ++i) {
            EXPECT_LE(std::abs(world->position(i).x - 10), half);
            farthest = std::max(farthest, std::abs(world->position(i).y));
        }
        EXPECT_LE(farthest, half);
        EXPECT_GT(farthest, half / 4);
    }
    Read beyond(replaced(text, "(10 cm, 0 cm)", "(20 cm, 0 cm)"));
    EXPECT_FALSE(start(beyond.scenario, 0, beyond.diagnostics));
    EXPECT_EQ(beyond.findings(), "4:25 RC-M03 the place of robots is outside the arena\n");
    Read whole(replaced(text, "around (10 cm, 0 cm) with 300 cm2 per robot", "in arena"));
    EXPECT_EQ(whole.findings(), "");
    EXPECT_TRUE(start(whole.scenario, 0, whole.diagnostics));
    EXPECT_EQ(Read(replaced(text, "0.09 m2", "900 cm")).findings(),
              "3:20 RC-M02 the area of a robot takes an area (cm2, m2)\n");
}

/// A chain with links shorter than a robot's diameter is impossible. Overlapping corners of one obstacle are reported
/// once.
TEST(Start, SaysWhatCannotBe) {
    const std::string linked = replaced(good, "place random in (40 cm, 40 cm) to (-40 cm, -40 cm)",
                                        "place linked around (0 cm, 0 cm) within 5 cm");
    Read close(linked);
    EXPECT_FALSE(start(close.scenario, 0, close.diagnostics));
    EXPECT_THAT(close.findings(), HasSubstr("10:3 RC-M03 robots that are linked are at least a diameter apart, 7 cm"));
    const std::string outside = replaced(replaced(good, " open", ""), "light lamp",
                                         "obstacle (200 cm, 0 cm), (210 cm, 0 cm), (200 cm, 9 cm) light lamp");
    EXPECT_EQ(Read(outside).findings(), "7:11 RC-M03 the obstacle is outside the arena\n");
}

/// 0.035 m is a little more than 3.5 cm as a double.
TEST(Start, RobotsMayBeLinkedWithinTheirDiameter) {
    const std::string linked = replaced(good, "place random in (40 cm, 40 cm) to (-40 cm, -40 cm)",
                                        "place linked around (50 cm, 10 cm) within 7 cm");
    for (const char* radius : {"radius 3.5 cm", "radius 0.035 m", "radius 35 mm"}) {
        Read read(replaced(linked, "radius 35 mm", radius));
        ASSERT_EQ(read.findings(), "") << radius;
        EXPECT_TRUE(start(read.scenario, 0, read.diagnostics)) << radius << read.findings();
    }
}

/// `pace` of the first kind can be written `all.pace` if the kind is called `all`. No kind may be called `environment`.
TEST(Scenario, AControllersConstantHasOneName) {
    const auto findings = [](const std::string& name, const std::string& varied) {
        const std::string named = replaced(good, "robots 12 {", "robots 12 " + name + " {");
        std::string text = replaced(named, "	pictures at 0 s, 1 s\n", "	" + varied + "\n");
        for (std::size_t at = text.find("\taccept"); at != std::string::npos; at = text.find("\taccept"))
            text.erase(at, text.find('\n', at) - at);
        return Read(text).findings();
    };
    EXPECT_EQ(findings("all", "vary const pace in 1, 2 vary const S::pace in 1, 2"), "") << "the model is to say";
    EXPECT_THAT(findings("all", "vary const pace in 1, 2 vary const all.pace in 1, 2"), HasSubstr("RC-M05"));
    EXPECT_EQ(findings("all", "vary const all.pace in 1, 2"), "");
    EXPECT_THAT(findings("environment", "vary const pace in 1, 2"),
                HasSubstr("RC-M05 the name 'environment', which the environment already has, is given twice"));
}

/// At most all twelve robots can fail. If their number varies, the limit at each point is its number of robots.
TEST(Scenario, NoMoreRobotsFailThanThereAre) {
    const auto findings = [](const std::string& items) {
        std::string text = replaced(good, "	pictures at 0 s, 1 s\n", "	" + items + "\n");
        for (std::size_t at = text.find("\taccept"); at != std::string::npos; at = text.find("\taccept"))
            text.erase(at, text.find('\n', at) - at);
        return Read(text).findings();
    };
    EXPECT_EQ(findings("failure of all at 1 s in 12 robots"), "");
    EXPECT_THAT(findings("failure of all at 1 s in 13 robots"), HasSubstr("RC-M03 13 robots fail of 12"));
    EXPECT_EQ(findings("failure of all at 1 s in 2 robots vary failures in 0 to 12"), "");
    EXPECT_THAT(findings("failure of all at 1 s in 2 robots vary failures in 0 to 13"),
                HasSubstr("RC-M03 13 robots fail of 12"));
    EXPECT_EQ(findings("failure of all at 1 s in 13 robots vary robots in 1 to 20"), "");
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

struct Mistake {
    const char* from;  ///< a part of the valid scenario, which is replaced
    const char* to;
    const char* note;
};

const Mistake mistakes[] = {
    {"scenario World for P::Roam", "scenario World P::Roam", "has the form `scenario NAME"},
    {"P::Roam {", "P.Roam {", "`PACKAGE::MODULE`"},
    {"for P::Roam {", "for P::Roam step", "has the form `scenario NAME"},
    {"robots 12 {", "robots {", "`robots 10 { ... }`"},
    {"record 200 ms", "record every 200 ms", "`record 0.2 s`"},
    {"trials 3", "trials = 3", "directly follows its keyword"},
    {"trials 3", "trials: 3", "directly follows its keyword"},
    {"drive motors by turn", "drive motors turn", "`drive motors by stop on halt`"},
    {"2 m by 100 cm", "2 m x 100 cm", "`arena 300 cm by 200 cm`"},
    {"feed a with", "feed a by", "`feed EVENT with"},
    {"stimulus e at 1 s", "stimulus e after 1 s", "`stimulus EVENT at 3 s`"},
    {"wall (0 cm, 0 cm) to (50 mm, -0.1 m)", "wall at (0 cm, 0 cm)", "`wall (0 cm, 0 cm) to"},
    {"wall (0 cm, 0 cm) to (50 mm, -0.1 m)", "obstacle at (0 cm, 0 cm)", "has corners"},
    {"place random in (40 cm, 40 cm) to (-40 cm, -40 cm)", "place random", "`place random in"},
    {"accept mean way", "accept way", "`probability P"},
    {"place at", "position at", "sets the initial places"},
    {"place at", "pose at", "sets the initial places"},
    {"place at", "start at", "sets the initial places"},
    {"trials 3", "trials 3;", "need no separator"},
    {"trials 3", "trials 3,", "need no separator"},
    {"light lamp", "# words\n\tlight lamp", "begins with `//`"},
    {"stimulus e at", "event e at", "`stimulus EVENT at 3 s`"},
    {"accept mean way", "expect mean way", "written after `accept`"},
    {"accept mean way", "assert mean way", "written after `accept`"},
    {"accept mean way", "check mean way", "written after `accept`"},
    {"light lamp", "goal lamp", "is a light"},
    {"light lamp", "target lamp", "is a light"},
    {"duration 2 s", "time 2 s", "`duration 10 s`"},
    {"duration 2 s", "length 2 s", "`duration 10 s`"},
    {"robots 12", "robot 12", "`robots`"},
    {"is proximity", "is radar", "there is line_of_sight, range_and_bearing, light_ring, proximity, ground"},
    {"is differential_drive", "is legs", "there is differential_drive"},
    {"eye.robot", "eye.wal", "`wall`"},
    {"eye.robot", "ear.robot", "there is eye, radio, ring, skin"},
    {"distance(lamp)", "distance(sun)", "there is lamp"},
};

TEST(Scenario, SaysWhatIsProbablyMeant) {
    std::set<std::string> given;
    for (const Mistake& mistake : mistakes) {
        const Read read(replaced(good, mistake.from, mistake.to));
        EXPECT_THAT(diagnostics::render_text(read.sources, read.diagnostics), HasSubstr(mistake.note)) << mistake.to;
        for (const diagnostics::Diagnostic& finding : read.diagnostics.sorted_findings())
            for (const diagnostics::Note& note : finding.notes) given.insert(note.message);
    }
    for (const diagnostics::Advice& row : scenario_advice()) {
        EXPECT_TRUE(given.contains(std::string(row.advice))) << row.words;
        EXPECT_FALSE(row.advice.ends_with('.')) << row.advice;
    }
}

}  // namespace
}  // namespace robochart::simulation
