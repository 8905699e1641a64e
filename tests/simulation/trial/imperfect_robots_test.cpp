// SPDX-License-Identifier: Apache-2.0
// Tests sensors with errors, robots that fail, messages received from neighbours, and moving lights. The tests compare
// measured rates with the specified ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/statistics/binomial.hpp"
#include "simulation/scenario/read_scenario.hpp"
#include "tests/simulation/harness.hpp"

namespace robochart::simulation {
namespace {

using testing::Experiment;
using ::testing::HasSubstr;
using testing::replaced;

/// The robot stands still until it sees another robot. Its states record a count and a message.
constexpr const char* looking = R"(
interface Ops { forward() }
interface Said { var saying : nat = 0 }
interface Events { event robot event clear event count : nat event heard : nat }
stm Look {
	requires Ops
	requires Said
	uses Events
	const word : nat = 1
	var n : nat
	initial i
	state Waiting { entry saying = word; forward() }
	state Seeing { }
	state One { }
	state Two { }
	state Heard { }
	junction j
	transition t0 { from i to Waiting }
	transition t1 { from Waiting to Seeing trigger robot }
	transition t2 { from Waiting to j trigger count?n }
	transition t3 { from j to One condition n == 1 }
	transition t4 { from j to Two condition n >= 2 }
	transition t5 { from j to Waiting condition n == 0 }
	transition t6 { from Waiting to Heard trigger heard?n condition n == 1 }
}
)";

constexpr const char* looking_world = R"(
scenario World for Look {
	step 0.1 s physics 0.01 s unit 0.1 s duration 0.2 s seed 1 trials 2000
	arena 400 cm by 400 cm
	robots 2 { radius 3 cm axle 5 cm wheel 10 cm/s
		place at (0 cm, 0 cm) heading 0 deg
		place at (20 cm, 0 cm) heading 0 deg }
	sensor eye is line_of_sight
	sensor radio is range_and_bearing { range 80 cm message saying }
	feed robot with eye.robot
	actuator motors is differential_drive
	drive motors by forward(10 cm/s) on forward
	measure seen is in_state(Seeing)
	measure fine is working
	estimate probability seen >= 100 % at 0.1 s with confidence 99.9 %
}
)";

/// Returns the states of the robots at the end of the first trial.
std::vector<std::string> ends(const std::string& text, const std::string& of = looking) {
    Experiment experiment(of, replaced(text, "trials 2000", "trials 1"));
    EXPECT_TRUE(experiment.diagnostics.ok()) << experiment.messages();
    const RunResult result = experiment.run();
    std::vector<std::string> states;
    const Machines machines = machines_of(experiment.controller->drive());
    const Frame& last = result.trials.at(0).frames.back();
    for (std::size_t robot = 0; robot < last.poses.size(); ++robot)
        states.push_back(machines.at(0).state_name(last.robot_state(robot)));
    return states;
}

TEST(SightErrors, ReadAndVary) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const Scenario read = read_scenario(
        sources,
        sources.add("s", replaced(looking_world, "line_of_sight", "line_of_sight { error 5 % false_positive 1 % }")),
        diagnostics);
    ASSERT_TRUE(diagnostics.ok());
    EXPECT_DOUBLE_EQ(read.sensors.at(0).false_negative, 0.05);
    EXPECT_DOUBLE_EQ(read.sensors[0].false_positive, 0.01);
}

/// Returns how many robots see another one in the first cycle, among 2000 pairs. The first robot of a pair looks at the
/// second, and the second looks at a wall.
std::pair<std::uint64_t, std::uint64_t> seeing(const std::string& options) {
    Experiment experiment(looking, replaced(looking_world, "line_of_sight", "line_of_sight { " + options + " }"));
    EXPECT_TRUE(experiment.diagnostics.ok()) << experiment.messages();
    const StageMaker maker = embedded_stage;
    std::pair<std::uint64_t, std::uint64_t> seen;
    for (std::uint32_t trial = 0; trial < 2000; ++trial) {
        const auto stage = maker(experiment.scenario, trial, experiment.diagnostics);
        stage->sense();
        seen.first += stage->line_of_sight(0, experiment.scenario.sensors[0]).what == Seen::robot ? 1U : 0U;
        seen.second += stage->line_of_sight(1, experiment.scenario.sensors[0]).what == Seen::robot ? 1U : 0U;
    }
    return seen;
}

TEST(SightErrors, AreAsFrequentAsTheySay) {
    EXPECT_EQ(seeing("").first, 2000U);
    EXPECT_EQ(seeing("").second, 0U);
    EXPECT_EQ(seeing("error 100 %").second, 2000U);
    EXPECT_EQ(seeing("error 100 %").first, 0U);
    const auto [missed, imagined] = seeing("false_negative 20 % false_positive 5 %");
    const auto first = statistics::clopper_pearson(missed, 2000, 1e-4);
    const auto second = statistics::clopper_pearson(imagined, 2000, 1e-4);
    EXPECT_TRUE(first.low <= 0.8 && 0.8 <= first.high) << missed;
    EXPECT_TRUE(second.low <= 0.05 && 0.05 <= second.high) << imagined;
}

/// Returns how many of 400 robots are in state Seeing after one cycle with this reading of this sensor. The two robots
/// of a pair are 20 cm apart, and 10 cm and 22 cm from the lamp.
std::uint64_t noticing(const std::string& sensor, const std::string& reading) {
    std::string text = replaced(looking_world, "line_of_sight", sensor);
    text = replaced(text, "eye.robot", "eye." + reading);
    text = replaced(text, "trials 2000", "trials 100");
    text = replaced(text, "duration 0.2 s", "duration 0.1 s");
    text.erase(text.find("\testimate"));
    Experiment experiment(looking, replaced(text + "}", "arena", "light lamp at (0 cm, 10 cm) arena"));
    EXPECT_TRUE(experiment.diagnostics.ok()) << experiment.messages();
    std::uint64_t robots = 0;
    for (const std::uint32_t seed : {1U, 1001U}) {
        experiment.scenario.seed = seed;
        for (const TrialResult& trial : experiment.run().trials)
            for (std::size_t robot = 0; robot < 2; ++robot) {
                const std::uint16_t state = trial.frames.back().robot_state(robot);
                robots += machines_of(experiment.controller->drive())[0].state_name(state) == "Seeing" ? 1U : 0U;
            }
    }
    return robots;
}

TEST(SensorErrors, OfProximityAndGroundAreAsFrequentAsTheySay) {
    const auto is_share = [](std::uint64_t seeing, double share) {
        const auto interval = statistics::clopper_pearson(seeing, 400, 1e-4);
        return interval.low <= share && share <= interval.high;
    };
    // The sensors are so dense that they miss no robot. The centres of robots of 3 cm radius are 20 cm apart, their
    // bodies 14 cm.
    EXPECT_EQ(noticing("proximity { sensors 64 range 20 cm }", "near(20 cm)"), 400U);
    EXPECT_EQ(noticing("proximity { sensors 64 range 20 cm error 100 % }", "near(20 cm)"), 0U);
    EXPECT_EQ(noticing("proximity { sensors 64 range 5 cm error 100 % }", "near(5 cm)"), 400U);
    const std::uint64_t missed = noticing("proximity { sensors 64 range 20 cm false_negative 30 % }", "near(20 cm)");
    EXPECT_TRUE(is_share(missed, 0.7)) << missed;
    EXPECT_EQ(noticing("ground { source lamp }", "on(15 cm)"), 200U) << "the first of each pair";
    const std::uint64_t imagined = noticing("ground { source lamp false_positive 20 % }", "on(5 cm)");
    EXPECT_TRUE(is_share(imagined, 0.2)) << imagined;
}

TEST(Neighbours, AreCounted) {
    const std::string counting =
        replaced(looking_world, "feed robot with eye.robot", "feed count with radio.count(30 cm)");
    EXPECT_EQ(ends(counting), (std::vector<std::string>{"One", "One"}));
    std::string three = replaced(counting, "robots 2", "robots 3");
    three = replaced(three, "place at (20 cm, 0 cm)", "place at (0 cm, -20 cm) heading 0 deg place at (20 cm, 0 cm)");
    EXPECT_EQ(ends(three), (std::vector<std::string>{"Two", "Two", "Two"}));
    EXPECT_EQ(ends(replaced(counting, "count(30 cm)", "count(10 cm)")),
              (std::vector<std::string>{"Waiting", "Waiting"}));
}

TEST(Messages, CarryWhatTheSenderWrote) {
    const std::string hearing =
        replaced(looking_world, "feed robot with eye.robot", "feed heard with radio.message(30 cm)");
    EXPECT_EQ(ends(hearing), (std::vector<std::string>{"Heard", "Heard"}));
    EXPECT_EQ(ends(hearing, replaced(looking, "const word : nat = 1", "const word : nat = 0")),
              (std::vector<std::string>{"Waiting", "Waiting"}))
        << "0 is not sent";
    Experiment without(looking, replaced(hearing, " message saying", ""));
    EXPECT_THAT(without.messages(), HasSubstr("the variable that 'radio' sends"));
}

TEST(Failures, OfARadioAreOnBothSides) {
    const std::string counting =
        replaced(looking_world, "feed robot with eye.robot", "feed count with radio.count(30 cm)");
    const std::string failing = replaced(counting, "actuator", "failure of radio at 0 s in 1 robots actuator");
    EXPECT_EQ(ends(failing), (std::vector<std::string>{"Waiting", "Waiting"}));
}

TEST(Failures, OfMotorsStopTheRobotAlone) {
    Experiment experiment(looking, replaced(replaced(replaced(looking_world, "trials 2000", "trials 1"),
                                                     "duration 0.2 s", "duration 2 s record 0.1 s"),
                                            "feed robot with eye.robot",
                                            "feed count with radio.count(1 cm) failure of motors at 1 s in 1 robots"));
    ASSERT_TRUE(experiment.diagnostics.ok()) << experiment.messages();
    const RunResult result = experiment.run();
    const auto& frames = result.trials.at(0).frames;
    EXPECT_NEAR(frames.at(20).poses[0].at.x, 10, 1e-9) << "10 cm/s for a second";
    EXPECT_NEAR(frames[20].poses[1].at.x, 40, 1e-9);
    EXPECT_NEAR(measure_value(experiment.scenario, experiment.scenario.measures[1], frames[9]), 1, 0);
    EXPECT_NEAR(measure_value(experiment.scenario, experiment.scenario.measures[1], frames[20]), 0.5, 0);
}

TEST(Failures, OfSensorsReportNothing) {
    const std::string failing = replaced(looking_world, "actuator", "failure of sensors at 0 s in 1 robots actuator");
    EXPECT_EQ(ends(failing), (std::vector<std::string>{"Waiting", "Waiting"}));
    EXPECT_EQ(ends(looking_world), (std::vector<std::string>{"Seeing", "Waiting"}));
}

/// Bjerknes and Winfield, DARS 2010: of n robots with mean lifetime m, at least k work at time t with R = sum over i >=
/// k of C(n, i) e^(-i t/m) (1 - e^(-t/m))^(n-i). The share of trials is close to R.
TEST(Failures, AreThoseOfTheFormulaForKOutOfN) {
    std::string text = replaced(looking_world, "place at (20 cm, 0 cm) heading 0 deg", "place random in arena");
    text = replaced(text, "robots 2", "robots 10");
    text = replaced(text, "actuator", "failure of all with mean time 8 s actuator");
    text = replaced(text, "duration 0.2 s", "duration 1 s");
    std::string claims;
    for (const int k : {10, 9, 8})
        claims += "estimate probability fine >= " + std::to_string(10 * k) + " % at 1 s with confidence 99.9 %\n";
    text = replaced(text, "estimate probability seen >= 100 % at 0.1 s with confidence 99.9 %", claims);
    Experiment experiment(looking, text);
    ASSERT_TRUE(experiment.diagnostics.ok()) << experiment.messages();
    const RunResult result = experiment.run();
    const double alive = std::exp(-1.0 / 8);
    for (std::size_t c = 0; c < 3; ++c) {
        const double expected = statistics::at_least(10 - c, 10, alive);
        EXPECT_EQ(result.claims.at(c).verdict, ClaimVerdict::estimated);
        EXPECT_EQ(result.claims[c].trial_count(), 2000U);
        EXPECT_LE(result.claims[c].interval.low, expected) << 10 - c;
        EXPECT_GE(result.claims[c].interval.high, expected) << 10 - c;
    }
}

TEST(Lights, Move) {
    Light light;
    light.at = {10, 0};
    light.to = {10, 30};
    EXPECT_EQ(light.position_at(5), (Vector{10, 0})) << "without a speed it stands";
    light.speed = 2;
    EXPECT_NEAR(light.position_at(5).y, 10, 1e-12);
    EXPECT_NEAR(light.position_at(100).y, 30, 1e-12) << "there it stays";
}

TEST(Obstacles, StandInTheWayAndHoldNobody) {
    EXPECT_TRUE(is_inside({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {5, 5}));
    EXPECT_FALSE(is_inside({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {15, 5}));
    // The notch has the form of an arrow with its inner corner at (5, 5).
    EXPECT_FALSE(is_inside({{0, 0}, {10, 0}, {5, 5}, {10, 10}, {0, 10}}, {8, 5}));
    WorldOptions options;
    options.arena.obstacles.push_back({{-120, -120}, {120, -120}, {120, 0}, {-120, 0}});
    World world(options, 1);
    ASSERT_TRUE(world.place_at_random(50, {{-125, -125}, {125, 125}}));
    for (std::size_t robot = 0; robot < world.size(); ++robot)
        EXPECT_FALSE(is_inside(options.arena.obstacles[0], world.position(robot)));
}

}  // namespace
}  // namespace robochart::simulation
