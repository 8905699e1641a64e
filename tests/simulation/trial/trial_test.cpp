// SPDX-License-Identifier: Apache-2.0
// Tests one robot with a small machine: its inputs, its motion, and the errors that stop it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "tests/simulation/harness.hpp"

namespace robochart::simulation {
namespace {

using testing::Experiment;
using ::testing::HasSubstr;
using testing::replaced;

/// The robot drives ahead until it is notified, then turns by a measured angle, then drives ahead.
constexpr const char* model = R"(
interface Ops { forward() turn(angle : real) ask() }
interface Vars { var seen : real = 0.3 }
interface Events { event wall event bearing : real event done }
stm Roam {
	requires Ops
	requires Vars
	uses Events
	var angle : real
	initial i
	state Going { entry forward() }
	state Asking { entry ask() }
	state Turning { entry turn(angle); wait(1) }
	transition t0 { from i to Going }
	transition t1 { from Going to Asking trigger wall }
	transition t2 { from Asking to Turning trigger bearing?angle }
	transition t3 { from Turning to Going trigger done }
}
)";

constexpr const char* scenario = R"(
scenario World for Roam {
	step 0.1 s physics 0.01 s unit 0.1 s duration 20 s trials 1 seed 1
	arena 100 cm by 100 cm
	robots 2 { radius 3.7 cm axle 5.1 cm wheel 12.8 cm/s
		place at (0 cm, 0 cm) heading 0 deg
		place at (0 cm, 20 cm) heading 0 deg }
	sensor eye is line_of_sight { range 10 cm }
	sensor radio is range_and_bearing { range 80 cm }
	feed wall with eye.wall
	feed bearing with radio.towards(80 cm) in deg on ask
	actuator motors is differential_drive
	drive motors by forward(10 cm/s) on forward
	drive motors by turn(5 cm/s, deg) on turn
	feed done with motors.turned
	record 0.1 s
}
)";

/// The first robot drives from 0 to the point at which the wall is 10 cm ahead of its front: 50 - 10 - 3.7 = 36.3 cm.
/// It sees the wall in the cycle after 3.7 s. Then the robot requests the angle, turns towards the other robot (to its
/// left), and drives on.
TEST(Trial, DrivesAsksTurnsAndDrivesOn) {
    Experiment experiment(model, scenario);
    ASSERT_EQ(experiment.codes(), "") << experiment.messages();
    const RunResult result = experiment.run();
    ASSERT_TRUE(result.trials.at(0).complete);
    const auto& frames = result.trials[0].frames;
    ASSERT_EQ(frames.size(), 201U);
    EXPECT_NEAR(frames[10].poses[0].at.x, 10, 1e-9) << "10 cm/s from the first cycle on";
    EXPECT_NEAR(frames[30].poses[0].at.x, 30, 1e-9);
    // The robot sees the wall at 37 cm, in cycle 37, and requests the angle. It drives for one more step, then turns by
    // the angle in the answer.
    EXPECT_NEAR(frames[60].poses[0].at.x, 38, 1e-6);
    // Both robots behave alike at the same time, so each has the other one directly to its left or to its right.
    EXPECT_NEAR(frames[60].poses[0].heading, std::numbers::pi / 2, 1e-9);
    EXPECT_NEAR(frames[60].poses[1].heading, -std::numbers::pi / 2, 1e-9);
}

TEST(Trial, TurnsAtTheRateOfItsWheels) {
    Experiment experiment(model, scenario);
    const RunResult result = experiment.run();
    const auto& frames = result.trials.at(0).frames;
    const double rate = 2 * 5 / 5.1;
    // The turn begins in cycle 38.
    EXPECT_NEAR(frames[42].poses[0].heading, 4 * 0.1 * rate, 1e-9);
}

TEST(Trial, AnswersTheReadingInItsUnit) {
    std::string in_radians = replaced(scenario, "in deg on ask", "in rad on ask");
    in_radians = replaced(in_radians, "turn(5 cm/s, deg)", "turn(5 cm/s, rad)");
    const std::string plain(model);
    Experiment degrees(plain, scenario);
    Experiment radians(plain, in_radians);
    EXPECT_NEAR(degrees.run().trials.at(0).frames[60].poses[0].heading,
                radians.run().trials.at(0).frames[60].poses[0].heading, 1e-9);
}

TEST(Trial, StepBoundStopsAtTheElement) {
    // A loop without time causes RC-M12.
    constexpr const char* loop = R"(
interface Ops { forward() }
stm Loop {
	requires Ops
	var n : nat
	initial i
	state A { entry forward() }
	state B { }
	transition t0 { from i to A }
	transition t1 { from A to B }
	transition t2 { from B to A }
}
)";
    Experiment experiment(loop, R"(
scenario World for Loop {
	step 0.1 s physics 0.01 s unit 0.1 s duration 1 s trials 1
	arena 100 cm by 100 cm
	robots 1 { place at (0 cm, 0 cm) heading 0 deg }
	actuator motors is differential_drive
	drive motors by forward(10 cm/s) on forward
}
)");
    const RunResult result = experiment.run();
    ASSERT_TRUE(result.has_stopped_trial());
    EXPECT_FALSE(result.all_hold());
    EXPECT_EQ(result.trials[0].steps, 0U);
    EXPECT_THAT(result.trials[0].stop->place,
                ::testing::AnyOf(HasSubstr("Loop::A"), HasSubstr("Loop::B"), HasSubstr("Loop::t")));
    EXPECT_THAT(experiment.codes(), HasSubstr("RC-M12"));
}

TEST(Trial, PreconditionStops) {
    constexpr const char* wrong = R"(
interface Vars { var speed : real }
operation Go(v : real) {
	precondition v > 0
	requires Vars
	initial i
	final F
	state S { entry speed = v }
	transition t0 { from i to S }
	transition t1 { from S to F }
}
interface Ops { Go(v : real) }
robotic platform P { provides Vars }
stm Wrong {
	requires Vars
	requires Ops
	initial i
	state A { entry Go(-1) }
	transition t0 { from i to A }
}
controller C {
	requires Vars
	opref go = Go
	sref s = Wrong
}
module M { rref p = P cref c = C }
)";
    Experiment experiment(wrong, R"(
scenario World for M {
	step 0.1 s physics 0.01 s unit 0.1 s duration 1 s trials 1
	arena 100 cm by 100 cm
	robots 1 { place at (0 cm, 0 cm) heading 0 deg }
}
)");
    const RunResult result = experiment.run();
    ASSERT_TRUE(result.has_stopped_trial()) << experiment.messages();
    EXPECT_THAT(result.trials[0].stop->cause, HasSubstr("precondition"));
}

class Counting final : public Trace {
public:
    void observe_cycle(std::size_t robot, std::uint64_t step, const rc_signal* inputs, const rc_actions& outputs,
                       rc_drive_result /*result*/) override {
        ++cycles;
        if (robot != 0) return;
        if (inputs[0].present != 0) seen.push_back(step);
        for (std::uint32_t a = 0; a < outputs.count; ++a) done.emplace_back(step, outputs.action[a].output);
    }
    std::size_t cycles = 0;
    std::vector<std::uint64_t> seen;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> done;
};

/// A trace receives every cycle of every robot, with its inputs and outputs.
TEST(Trial, TellsATrace) {
    Experiment experiment(model, scenario);
    std::string error;
    const auto controller = Controller::build(experiment.emission, "", error);
    ASSERT_NE(controller, nullptr) << error;
    ASSERT_EQ(experiment.emission.inputs.at(0).name, "wall");
    const auto stage = embedded_stage(experiment.scenario, 0, experiment.diagnostics);
    Counting trace;
    TrialOptions options;
    options.trace = &trace;
    ASSERT_TRUE(run_trial(experiment.plan, controller->drive(), *stage, options).complete);
    EXPECT_EQ(trace.cycles, 2 * 200U);
    EXPECT_EQ(trace.seen.at(0), 37U) << "the wall, from 37 cm on";
    ASSERT_GE(trace.done.size(), 2U);
    EXPECT_EQ(trace.done[0].first, 0U) << "forward at once";
    EXPECT_EQ(trace.done[1].first, 37U) << "asks when it sees the wall";
    EXPECT_EQ(experiment.emission.outputs.at(trace.done[1].second).name, "ask");
}

/// Shared variables are inputs like events, and the environment raises events at given times.
TEST(Trial, FeedsVariablesAndStimuli) {
    constexpr const char* machine = R"(
interface Ops { forward() halt() }
interface Vars { var ahead : real = 99 }
interface Events { event start event limit : real event sign : boolean }
stm Roam {
	requires Ops
	requires Vars
	uses Events
	var most : real = 0
	var go : boolean = false
	initial i
	state Waiting { entry halt() }
	state Ready { }
	state Asked { }
	state Going { entry forward() }
	transition t0 { from i to Waiting }
	transition t1 { from Waiting to Ready trigger start }
	transition t2 { from Ready to Asked trigger limit?most }
	transition t3 { from Asked to Going trigger sign?go }
	transition t4 { from Going to Waiting condition ahead < most /\ go == true }
}
)";
    Experiment experiment(machine, R"(
scenario World for Roam {
	step 0.1 s physics 0.01 s unit 0.1 s duration 10 s trials 1
	arena 100 cm by 100 cm
	robots 1 { radius 3.7 cm axle 5.1 cm wheel 12.8 cm/s place at (0 cm, 0 cm) heading 0 deg }
	sensor eye is line_of_sight
	feed ahead with eye.distance in cm
	actuator motors is differential_drive
	drive motors by forward(10 cm/s) on forward
	drive motors by stop on halt
	stimulus start at 1 s
	stimulus limit = 20.5 at 1.5 s
	stimulus sign = true every 2 s
	record 0.1 s
}
)");
    ASSERT_EQ(experiment.codes(), "") << experiment.messages();
    const RunResult result = experiment.run();
    ASSERT_FALSE(result.has_stopped_trial()) << experiment.messages();
    const auto& frames = result.trials.at(0).frames;
    EXPECT_NEAR(frames[20].poses[0].at.x, 0, 1e-9) << "waits for the sign at 2 s";
    EXPECT_NEAR(frames[21].poses[0].at.x, 1, 1e-9);
    // The wall is initially 50 - 3.7 = 46.3 cm ahead. It is less than 20.5 cm ahead from x = 26 on (the robot passes
    // 25.8 between steps).
    EXPECT_NEAR(frames[100].poses[0].at.x, 26, 1e-9);
}

/// The stimuli are literals and constants of the model. The robot continues at FAR, but at no other literal or number.
class NamedStimuli : public ::testing::Test {
protected:
    static std::string codes(const std::string& stimuli) { return experiment(stimuli)->codes(); }
    static std::unique_ptr<Experiment> experiment(const std::string& stimuli) {
        return std::make_unique<Experiment>(R"(
package p
enumeration Zone { NEAR FAR OUT }
enumeration Other { LEFT }
interface Ops { forward() halt() }
interface Events { event zone : Zone event limit : real event count : nat event sign : boolean }
stm Keep {
	requires Ops
	uses Events
	const most : nat = 7
	const half : real = 0.5
	const away : Zone = FAR
	const yes : boolean = true
	var z : Zone
	var r : real
	var n : nat
	var b : boolean
	initial i
	state Waiting { entry halt() }
	state Going { entry forward() }
	transition t0 { from i to Waiting }
	transition t1 { from Waiting to Waiting trigger zone?z condition z != Zone::FAR }
	transition t2 { from Waiting to Going trigger zone?z condition z == Zone::FAR }
	transition t3 { from Going to Going trigger limit?r condition r != 0.5 }
	transition t4 { from Going to Waiting trigger limit?r condition r == 0.5 }
	transition t5 { from Waiting to Waiting trigger count?n }
	transition t6 { from Waiting to Waiting trigger sign?b }
}
)",
                                            "scenario World for Keep {\n" + stimuli + R"(
	step 0.1 s physics 0.01 s unit 0.1 s duration 3 s trials 1
	arena 100 cm by 100 cm
	robots 1 { radius 3.7 cm axle 5.1 cm wheel 12.8 cm/s place at (0 cm, 0 cm) heading 0 deg }
	actuator motors is differential_drive
	drive motors by forward(10 cm/s) on forward
	drive motors by stop on halt
	record 0.1 s
}
)");
    }
    static constexpr const char* others = "stimulus count = most at 3 s\nstimulus sign = yes at 3 s\n";
};

TEST_F(NamedStimuli, AreLiteralsAndConstantsOfTheModel) {
    const auto run = experiment(std::string("stimulus zone = OUT at 0.5 s\nstimulus zone = Zone::FAR at 1 s\n"
                                            "stimulus limit = Keep::half at 2 s\n") +
                                others);
    ASSERT_EQ(run->codes(), "") << run->messages();
    const RunResult result = run->run();
    ASSERT_FALSE(result.has_stopped_trial()) << run->messages();
    const auto& frames = result.trials.at(0).frames;
    EXPECT_NEAR(frames[10].poses[0].at.x, 0, 1e-9) << "OUT is not FAR";
    EXPECT_NEAR(frames[20].poses[0].at.x, 10, 1e-9) << "ten steps of a centimetre since FAR";
    EXPECT_NEAR(frames[30].poses[0].at.x, 10, 1e-9) << "until 0.5";
    EXPECT_EQ(codes(std::string("stimulus zone = p::Zone::NEAR at 1 s stimulus zone = away at 2 s "
                                "stimulus limit = most at 1 s ") +
                    others),
              "");
}

TEST_F(NamedStimuli, ThatDoNotFitAreErrors) {
    const std::string rest = std::string("stimulus zone = NEAR at 1 s stimulus limit = 1 at 1 s ") + others;
    EXPECT_EQ(codes("stimulus zone = LEFT at 1 s " + rest), "RC-M07");
    EXPECT_EQ(codes("stimulus zone = Other::NEAR at 1 s " + rest), "RC-M07");
    EXPECT_EQ(codes("stimulus zone = 1 at 1 s " + rest), "RC-M08");
    EXPECT_EQ(codes("stimulus zone = most at 1 s " + rest), "RC-M08");
    EXPECT_EQ(codes("stimulus limit = yes at 1 s " + rest), "RC-M08");
    EXPECT_EQ(codes("stimulus count = half at 1 s " + rest), "RC-M08");
    EXPECT_EQ(codes("stimulus count = 1.5 at 1 s " + rest), "RC-M08");
    EXPECT_EQ(codes("stimulus limit = ; at 1 s " + rest), "RC-M01");
    const auto misspelt = experiment("stimulus zone = NAER at 1 s " + rest);
    EXPECT_THAT(misspelt->messages(), HasSubstr("NEAR"));
}

TEST(Controller, CompilerThatFailsIsReported) {
    // The message of RC-M11 contains this text.
    Experiment experiment(model, scenario);
    std::string error;
    EXPECT_EQ(Controller::build(experiment.emission, "false", error), nullptr);
    EXPECT_THAT(error, HasSubstr("false failed with status 1"));
    EXPECT_THROW((void)Controller::build(experiment.emission, "no-such-compiler", error), cpp_emit::NoCompiler);
}

TEST(Controller, StatesLieSideBySideAndAligned) {
    Experiment experiment(model, scenario);
    std::string error;
    const auto controller = Controller::build(experiment.emission, "", error);
    ASSERT_NE(controller, nullptr) << error;
    ControllerArray array(controller->drive(), 3);
    const auto address = [&](std::size_t i) { return reinterpret_cast<std::uintptr_t>(array[i]); };
    EXPECT_EQ(address(0) % controller->drive().state_alignment, 0U);
    EXPECT_EQ(address(2) - address(1), address(1) - address(0));
    EXPECT_GE(address(1) - address(0), controller->drive().state_size);
}

/// If ten is squared nine times, the result is not a finite number, and the difference of two such results is not a
/// number. The world cannot use either, so the trial stops and reports the element of the model.
TEST(Trial, CommandsThatAreNoFiniteNumbersStopIt) {
    constexpr const char* squares = R"(
interface Speeds { var linear : real = 0 var angular : real = 0 turn(by : real) }
stm Grows {
	requires Speeds
	var x : real = 10
	initial i
	state Growing { entry ENTRY }
	transition t0 { from i to Growing }
	transition t1 { from Growing to Growing action x = x * x; wait(1) }
}
)";
    constexpr const char* plane = R"(
scenario World for Grows {
	step 0.1 s physics 0.01 s unit 0.1 s duration 2 s trials 1
	arena 400 cm by 400 cm
	robots 1 { place at (0 cm, 0 cm) heading 0 deg }
	actuator motors is differential_drive
	DRIVE
	measure out is spread
	accept each out <= 1 cm
}
)";
    const auto stopped = [&](const std::string& entry, const std::string& drive) {
        Experiment experiment(replaced(squares, "ENTRY", entry), replaced(plane, "DRIVE", drive));
        EXPECT_EQ(experiment.codes(), "");
        const RunResult result = experiment.run();
        EXPECT_TRUE(result.has_stopped_trial());
        EXPECT_FALSE(result.all_hold());
        EXPECT_THAT(experiment.codes(), HasSubstr("RC-M12"));
        EXPECT_THAT(experiment.messages(), HasSubstr("a number that is not finite"));
        return result.trials.empty() || !result.trials[0].stop ? -1 : result.trials[0].stop->time;
    };
    const std::string speeds = "drive motors by speeds(linear in cm/s, angular in rad/s)";
    // The result 10^512 is not finite. The robot computes it after nine squarings, in the cycles at 0.0 s to 0.8 s or
    // from 0.1 s to 0.9 s.
    EXPECT_NEAR(stopped("linear = x", speeds), 0.85, 0.06);
    EXPECT_NEAR(stopped("linear = x - x", speeds), 0.85, 0.06) << "0 at first";
    EXPECT_NEAR(stopped("turn(x - x)", "drive motors by turn(12 cm/s, rad) on turn"), 0.85, 0.06);
}

}  // namespace
}  // namespace robochart::simulation
