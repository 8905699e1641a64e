// SPDX-License-Identifier: Apache-2.0
// Tests several kinds of robots with separate models, and the machine of an environment.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>

#include <cmath>

#include "tests/simulation/harness.hpp"

namespace robochart::simulation {
namespace {

using testing::Experiment;
using ::testing::HasSubstr;
using testing::replaced;

/// A robot that drives forward from the start.
constexpr const char* runner = R"(
interface Legs { run() }
interface Ears { event shout }
stm Runner {
	requires Legs
	uses Ears
	initial i
	state Waiting { }
	state Running { entry run() }
	transition t0 { from i to Waiting }
	transition t1 { from Waiting to Running trigger shout }
}
)";

/// A robot that drives back for the number of time units in its constant, and sends its number.
constexpr const char* backer = R"(
interface Wheels { back() halt() }
interface Says { var word : nat = 0 }
stm Backer {
	requires Wheels
	requires Says
	const pace : nat = 3
	clock T
	initial i
	state Backing { entry word = 7; back() }
	state Standing { entry halt() }
	transition t0 { from i to Backing action # T }
	transition t1 { from Backing to Standing condition since(T) >= pace }
}
)";

constexpr const char* mixed = R"(
scenario Mixed for Runner {
	step 0.1 s physics 0.01 s unit 0.1 s duration 2 s trials 1 seed 1
	arena 400 cm by 400 cm
	robots 2 runners { radius 3 cm axle 5 cm wheel 10 cm/s
		place at (0 cm, 0 cm) heading 0 deg
		place at (0 cm, 50 cm) heading 0 deg }
	actuator motors is differential_drive
	drive motors by forward(10 cm/s) on run
	stimulus shout at 0.5 s
	robots 1 backers for Backer {
		place at (0 cm, 100 cm) heading 0 deg
		drive motors by forward(-10 cm/s) on back
		drive motors by stop on halt
	}
	measure all is inside (10 cm, -200 cm) to (200 cm, 200 cm)
	measure some is inside (10 cm, -200 cm) to (200 cm, 200 cm) of runners
	measure none is inside (10 cm, -200 cm) to (200 cm, 200 cm) of backers
	measure going is in_state(Running)
	measure standing is in_state(Standing) of backers
	accept each all in 66 % to 67 %
	accept each some >= 100 %
	accept each none <= 0 %
	accept each going in 66 % to 67 %
	accept each standing >= 100 %
}
)";

TEST(Kinds, EachHasItsModelItsPlacesAndItsPlatform) {
    Experiment experiment(runner, mixed, "model.rct", {backer});
    const RunResult result = experiment.run();
    for (std::size_t b = 0; b < result.bands.size(); ++b)
        EXPECT_TRUE(result.bands[b].holds) << experiment.scenario.bands[b].text << ": " << result.bands[b].value;
    const Frame& last = result.trials.at(0).frames.back();
    ASSERT_EQ(last.poses.size(), 3U);
    // The signal comes in the cycle at 0.5 s. From then on the robot drives for 1.5 s at 10 cm/s.
    EXPECT_NEAR(last.poses[0].at.x, 15, 1e-9);
    EXPECT_NEAR(last.poses[1].at.x, 15, 1e-9);
    // The robot drives backwards for three time units of 0.1 s.
    EXPECT_NEAR(last.poses[2].at.x, -3, 1e-9);
    const Machines machines = machines_of(experiment.scenario, experiment.drives());
    ASSERT_EQ(machines.size(), 1U);
    EXPECT_EQ(machines[0].state_name(last.robot_state(0)), "runners::Running");
    EXPECT_EQ(machines[0].state_name(last.robot_state(2)), "backers::Standing");
}

TEST(Kinds, AKindThatIsCalledLikeAStateMakesItsNameMeanTwoThings) {
    std::string text = mixed;
    for (std::size_t at = text.find("runners"); at != std::string::npos; at = text.find("runners", at + 7))
        text.replace(at, 7, "Running");
    Experiment experiment(runner, text, "model.rct", {backer});
    (void)experiment.run();
    EXPECT_THAT(experiment.messages(), HasSubstr("there is no state that is not called as a kind of robots is, named "
                                                 "'Running'"));
}

TEST(Kinds, WithoutTheOthersTheFirstDoesTheSame) {
    // The robots are too far apart to meet, so each kind moves as it does alone.
    std::string alone = mixed;
    alone.erase(alone.find("\trobots 1 backers"), alone.find("\tmeasure all") - alone.find("\trobots 1 backers"));
    alone.erase(alone.find("\tmeasure all"));
    Experiment one(runner, alone + "}\n");
    Experiment both(runner, mixed, "model.rct", {backer});
    const RunResult a = one.run();
    const RunResult b = both.run();
    ASSERT_EQ(a.trials[0].frames.size(), b.trials[0].frames.size());
    for (std::size_t f = 0; f < a.trials[0].frames.size(); ++f)
        for (std::size_t robot = 0; robot < 2; ++robot)
            EXPECT_EQ(a.trials[0].frames[f].poses[robot].at, b.trials[0].frames[f].poses[robot].at);
}

/// Wheels, axle and noise are those of the first kind unless the kind states its own. With a fifth of the speed, the
/// robot drives a fifth of the distance.
TEST(Kinds, DriveByWheelsOfTheirOwn) {
    const auto at_end = [](const std::string& own) {
        std::string text = replaced(mixed, "place at (0 cm, 100 cm)", own + " place at (0 cm, 100 cm)");
        text.erase(text.find("\tmeasure all"));
        Experiment experiment(runner, text + "}\n", "model.rct", {backer});
        return experiment.run().trials.at(0).frames.back().poses;
    };
    const auto slow = at_end("wheel 2 cm/s");
    EXPECT_NEAR(slow[2].at.x, -0.6, 1e-9);
    EXPECT_NEAR(slow[0].at.x, 15, 1e-9) << "of the others nothing changes";
    EXPECT_GT(std::abs(at_end("noise 20 % axle 2.5 cm")[2].at.x + 3), 1e-6);
    Experiment other(runner, replaced(mixed, "place at (0 cm, 100 cm)", "radius 4 cm place at (0 cm, 100 cm)"),
                     "model.rct", {backer});
    EXPECT_THAT(other.codes(), HasSubstr("RC-M03"));
    EXPECT_THAT(other.messages(), HasSubstr("robots of all kinds have the radius of the first"));
}

TEST(Kinds, FailuresAreOfOneKind) {
    const std::string failing = replaced(replaced(mixed, "drive motors by stop on halt",
                                                  "drive motors by stop on halt failure of all at 0 s in 1 robots"),
                                         "measure going",
                                         "measure well is working of backers measure fine is working of runners "
                                         "accept each well <= 0 % accept each fine >= 100 % measure going");
    Experiment experiment(runner, replaced(failing, "accept each standing >= 100 %", ""), "model.rct", {backer});
    const RunResult result = experiment.run();
    for (std::size_t b = 0; b < result.bands.size(); ++b)
        EXPECT_TRUE(result.bands[b].holds) << experiment.scenario.bands[b].text;
    EXPECT_EQ(result.trials[0].frames.back().poses[2].at, (Vector{0, 100})) << "its controller never ran";
}

TEST(Kinds, OneKindHearsWhatAnotherSends) {
    constexpr const char* listener = R"(
interface Ears { event heard : nat }
stm Listener {
	uses Ears
	var n : nat
	initial i
	state Deaf { }
	state Knows { }
	transition t0 { from i to Deaf }
	transition t1 { from Deaf to Knows trigger heard?n condition n == 7 }
}
)";
    std::string text = replaced(mixed, "for Runner", "for Listener");
    text = replaced(text, "\tdrive motors by forward(10 cm/s) on run\n\tstimulus shout at 0.5 s\n",
                    "\tsensor radio is range_and_bearing { range 120 cm transparent message word }\n"
                    "\tfeed heard with radio.message(120 cm)\n");
    text.erase(text.find("\tmeasure all"));
    text += "measure knows is in_state(Knows) accept each knows in 66 % to 67 % }\n";
    Experiment experiment(listener, text, "model.rct", {backer});
    const RunResult result = experiment.run();
    EXPECT_TRUE(result.bands.at(0).holds) << result.bands.at(0).value;
}

TEST(Kinds, WhatDoesNotFitIsReported) {
    const auto codes = [](const std::string& text) { return Experiment(runner, text, "model.rct", {backer}).codes(); };
    EXPECT_EQ(codes(replaced(mixed, "robots 1 backers for", "robots 1 for")), "RC-M04 RC-M06 RC-M06");
    EXPECT_EQ(codes(replaced(mixed, "robots 1 backers for Backer {", "robots 1 backers {")), "RC-M05 RC-M01");
    EXPECT_EQ(codes(replaced(mixed, "place at (0 cm, 100 cm) heading 0 deg\n\t\tdrive", "drive")), "RC-M04");
    EXPECT_EQ(codes(replaced(mixed, "of backers\n", "of barkers\n")), "RC-M06 RC-M06");
    EXPECT_EQ(codes(replaced(mixed, "on halt", "on run")), "RC-M19 RC-M07 RC-U01") << "an operation of the other kind";
    EXPECT_EQ(codes(replaced(mixed, "robots 1 backers", "robots 1 runners")), "RC-M05 RC-M06 RC-M06");
}

/// An environment that counts to its constant, and then performs two actions.
constexpr const char* keeper = R"(
interface Acts { act(x : real, y : real) stop() }
interface Watch { event late event seen : boolean event share : real }
stm Keeper {
	requires Acts
	uses Watch
	var there : boolean = false
	var part : real = 0
	initial i
	state Watching { }
	state Acting { entry act(10, 20); stop() }
	state Done { }
	transition t0 { from i to Watching }
	transition t1 { from Watching to Acting trigger late }
	transition t2 { from Acting to Done trigger seen?there condition there }
	transition t3 { from Done to Done trigger share?part }
}
)";

constexpr const char* watched = R"(
scenario Watched for Runner {
	step 0.1 s physics 0.01 s unit 0.1 s duration 3 s trials 2 seed 1
	arena 400 cm by 400 cm
	light lamp at (0 cm, 0 cm)
	obstacle gate (100 cm, -50 cm), (110 cm, -50 cm), (110 cm, 50 cm), (100 cm, 50 cm) absent
	robots 2 { radius 3 cm axle 5 cm wheel 10 cm/s
		place at (0 cm, 0 cm) heading 0 deg
		place at (0 cm, 50 cm) heading 0 deg }
	actuator motors is differential_drive
	drive motors by forward(10 cm/s) on run
	measure clock is time
	measure out is inside (5 cm, -200 cm) to (200 cm, 200 cm)
	measure fine is working
	measure home is distance(lamp)
	environment Keeper {
		feed late when clock >= 1 s
		feed seen when out >= 100 %
		feed share with out in %
		drive lamp by move(cm, 10 cm/s) on act
		drive gate by appear on stop
		stimulus shout on act
	}
	record 0.1 s
}
)";

const Frame& frame_near(const RunResult& result, double time) {
    const auto& frames = result.trials.at(0).frames;
    return *std::ranges::min_element(
        frames, [&](const Frame& a, const Frame& b) { return std::abs(a.time - time) < std::abs(b.time - time); });
}

TEST(WorldMachine, MovesLightsShowsObstaclesAndRaisesEvents) {
    Experiment experiment(runner, watched, "model.rct", {keeper});
    const RunResult result = experiment.run();
    // The event is read in the cycle at 1 s, and the action takes effect in the next cycle.
    EXPECT_EQ(frame_near(result, 1).lights.at(0).at, (Vector{0, 0}));
    EXPECT_FALSE(frame_near(result, 1).obstacles.at(0));
    EXPECT_TRUE(frame_near(result, 1.1).obstacles.at(0));
    // The lamp is 22.36 cm from its target (10, 20) and moves at 10 cm/s. After one second it has moved 10 cm.
    EXPECT_NEAR(length(frame_near(result, 2).lights.at(0).at), 10, 1e-6);
    EXPECT_NEAR(frame_near(result, 2).lights.at(0).at.y, 2 * frame_near(result, 2).lights.at(0).at.x, 1e-6);
    // The robots read the event in the cycle at 1.1 s, and drive for 1.9 s.
    EXPECT_NEAR(result.trials.at(0).frames.back().poses[0].at.x, 19, 1e-6);
}

TEST(WorldMachine, ReadsConditionsAndMeasures) {
    Experiment experiment(
        runner,
        replaced(watched, "stimulus shout on act", "stimulus shout on act failure of motors in 1 robots on stop"),
        "model.rct", {keeper});
    const RunResult result = experiment.run();
    const Frame& last = result.trials.at(0).frames.back();
    EXPECT_EQ(std::ranges::count(last.working, false), 1);
    // One of the two robots, chosen at random, stands still. Over many trials, it is not always the same robot.
    Experiment many(runner,
                    replaced(replaced(watched, "stimulus shout on act",
                                      "stimulus shout on act failure of motors in 1 robots on stop"),
                             "trials 2", "trials 40"),
                    "model.rct", {keeper});
    std::size_t first = 0;
    for (const TrialResult& trial : many.run().trials) first += trial.frames.back().working[0] ? 1U : 0U;
    EXPECT_GE(first, 5U);
    EXPECT_LE(first, 35U);
}

TEST(WorldMachine, SwitchedOffALightIsNotSensed) {
    constexpr const char* seeker = R"(
interface Eyes { event lit : boolean }
stm Seeker {
	uses Eyes
	var there : boolean
	initial i
	state Dark { }
	state Light { }
	transition t0 { from i to Dark }
	transition t1 { from Dark to Light trigger lit?there condition there }
	transition t2 { from Light to Dark trigger lit?there condition not there }
}
)";
    std::string text = replaced(watched, "for Runner", "for Seeker");
    text = replaced(text, "drive motors by forward(10 cm/s) on run",
                    "sensor ring is light_ring { source lamp } feed lit with ring.lit(1)");
    text = replaced(text, "\t\tstimulus shout on act\n", "");
    text = replaced(text, "light lamp at (0 cm, 0 cm)", "light lamp at (150 cm, 150 cm)");
    text = replaced(text, "drive lamp by move(cm, 10 cm/s) on act", "drive lamp by switch_off on act");
    text = replaced(text, "measure clock is time",
                    "measure bright is in_state(Light) accept each bright at 0.9 s >= 100 % "
                    "accept each bright <= 0 % measure clock is time");
    Experiment experiment(seeker, text, "model.rct", {keeper});
    const RunResult result = experiment.run();
    EXPECT_TRUE(result.bands.at(0).holds) << result.bands.at(0).value;
    EXPECT_TRUE(result.bands.at(1).holds) << result.bands.at(1).value;
}

TEST(WorldMachine, SameSeedsGiveTheSameBitsForAnyNumberOfThreads) {
    const std::string text =
        replaced(watched, "stimulus shout on act", "stimulus shout on act failure of all in 1 robots on stop");
    Experiment a(runner, replaced(text, "trials 2", "trials 8"), "model.rct", {keeper});
    Experiment b(runner, replaced(text, "trials 2", "trials 8"), "model.rct", {keeper});
    const RunResult one = a.run(1);
    const RunResult four = b.run(4);
    for (std::size_t t = 0; t < 8; ++t)
        for (std::size_t robot = 0; robot < 2; ++robot)
            EXPECT_EQ(one.trials[t].frames.back().poses[robot].at, four.trials[t].frames.back().poses[robot].at);
}

TEST(WorldMachine, WhatDoesNotFitIsReported) {
    const auto codes = [](const std::string& text) { return Experiment(runner, text, "model.rct", {keeper}).codes(); };
    EXPECT_EQ(codes(replaced(watched, "feed late when", "feed seen with out in % feed late when")), "RC-M08");
    EXPECT_EQ(codes(replaced(watched, "feed share with", "feed shares with")), "RC-M14 RC-M07");
    EXPECT_EQ(codes(replaced(watched, "feed share with out", "feed share with inn")), "RC-M06");
    EXPECT_EQ(
        codes(replaced(watched, "drive lamp by move(cm, 10 cm/s) on act", "drive lamp by move(cm, 10 cm/s) on stop")),
        "RC-M08");
    EXPECT_EQ(codes(replaced(watched, "drive gate by appear", "drive gate by move")), "RC-M01");
    EXPECT_EQ(codes(replaced(watched, "drive gate by", "drive door by")), "RC-M06");
    EXPECT_EQ(codes(replaced(watched, "stimulus shout on act", "stimulus shouts on act")), "RC-M14 RC-M07");
    EXPECT_EQ(codes(replaced(watched, "stimulus shout on act", "stimulus shout on acts")), "RC-M07");
    EXPECT_EQ(codes(replaced(watched, "when clock >= 1 s", "when clock >= 1 s within 2 s")), "RC-M16");
}

/// Each kind gets the event as its model declares it. The first gets it with the command's argument, the other without
/// a value.
TEST(WorldMachine, EachKindGetsTheValueThatItsEventCarries) {
    constexpr const char* valued = R"(
interface Legs { run() }
interface Ears { event shout : real }
stm Runner {
	requires Legs
	uses Ears
	var x : real = 0
	initial i
	state Waiting { }
	state Running { entry run() }
	transition t0 { from i to Waiting }
	transition t1 { from Waiting to Running trigger shout?x condition x > 9 }
}
)";
    constexpr const char* plain = R"(
interface Ears { event shout }
stm Plain {
	uses Ears
	initial i
	state Waiting { }
	state Awake { }
	transition t0 { from i to Waiting }
	transition t1 { from Waiting to Awake trigger shout }
}
)";
    const std::string text = replaced(watched, "measure clock is time",
                                      "robots 1 plain for Plain { place at (0 cm, 100 cm) heading 0 deg }\n"
                                      "measure run is in_state(Running) measure awake is in_state(Awake) of plain\n"
                                      "accept each run in 66 % to 67 % accept each awake >= 100 %\n"
                                      "measure clock is time");
    const std::string keeper_of_one =
        replaced(replaced(keeper, "act(x : real, y : real)", "act(x : real)"), "act(10, 20)", "act(10)");
    Experiment experiment(valued, replaced(text, "\t\tdrive lamp by move(cm, 10 cm/s) on act\n", ""), "model.rct",
                          {plain, keeper_of_one});
    ASSERT_EQ(experiment.codes(), "");
    const RunResult result = experiment.run();
    for (std::size_t b = 0; b < result.bands.size(); ++b)
        EXPECT_TRUE(result.bands[b].holds) << experiment.scenario.bands[b].text << ": " << result.bands[b].value;
}

/// The environment reads the states at the time when the robots sensed. So it does not yet see the new state of a robot
/// that starts to run in this cycle.
TEST(WorldMachine, ReadsStatesAsTheyWereWhenTheRobotsSensed) {
    std::string text = replaced(watched, "measure out is inside (5 cm, -200 cm) to (200 cm, 200 cm)",
                                "measure out is inside (5 cm, -200 cm) to (200 cm, 200 cm) "
                                "measure running is in_state(Running)");
    text = replaced(text, "\t\tstimulus shout on act\n", "");
    text = replaced(text, "\trecord", "\tstimulus shout at 0.5 s\n\trecord");
    text = replaced(text, "feed late when clock >= 1 s", "feed late when running >= 100 %");
    Experiment experiment(runner, text, "model.rct", {keeper});
    const RunResult result = experiment.run();
    // The robot has been running since the cycle at 0.5 s. The environment reads this in the cycle at 0.6 s, and its
    // action takes effect after that step.
    EXPECT_FALSE(frame_near(result, 0.6).obstacles.at(0));
    EXPECT_TRUE(frame_near(result, 0.7).obstacles.at(0));
}

TEST(WorldMachine, StopsATrialByItself) {
    constexpr const char* endless = R"(
interface Watch { event late }
stm Keeper {
	uses Watch
	initial i
	state A { }
	state B { }
	transition t0 { from i to A }
	transition t1 { from A to B trigger late }
	transition t2 { from B to B }
}
)";
    std::string text = watched;
    for (const char* line : {"\t\tfeed seen when out >= 100 %\n", "\t\tfeed share with out in %\n",
                             "\t\tdrive lamp by move(cm, 10 cm/s) on act\n", "\t\tdrive gate by appear on stop\n",
                             "\t\tstimulus shout on act\n"})
        text = replaced(text, line, "");
    Experiment experiment(runner, text, "model.rct", {endless});
    const RunResult result = experiment.run();
    ASSERT_TRUE(result.trials.at(0).stop);
    EXPECT_TRUE(result.trials[0].stop->environment);
    EXPECT_THAT(experiment.messages(), HasSubstr("the controller of the environment stopped trial 1 at 1.0 s"));
}

}  // namespace
}  // namespace robochart::simulation
