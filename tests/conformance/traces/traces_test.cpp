// SPDX-License-Identifier: Apache-2.0
// Compares logs of runs with the model: accepted logs, rejected logs and their reports, omissions in partial logs, and
// the format of logs. The expectations follow by hand from the models.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "conformance/model/rules.hpp"
#include "conformance/traces/logged_numbers.hpp"
#include "conformance/traces/more_numbers.hpp"
#include "conformance/traces/trace_check.hpp"
#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A model with a checker of logs for one of its components.
class Replay {
public:
    Replay(const std::string& folder, const std::string& component, std::uint32_t cycle = 1)
        : project_(folder),
          component_(component == "module" ? project_.first_module() : project_.machine_named(component)),
          cycle_(cycle),
          instantiation_(with_more_numbers(project_.system, project_.instantiation, component_)),
          model_(load_model(instantiation_)) {
        EXPECT_TRUE(project_.diagnostics.ok());
        checker_ = std::make_unique<TraceChecker>(*model_, std::vector<std::string>{"M"}, limits_, project_.sources);
    }

    /// Checks the runs of a log and stores the reports of those that are not accepted. The lines of `header` come after
    /// the first lines of the log.
    LogReport check_runs(const std::string& runs, const std::string& header = "") {
        return check_whole_log("robochart-trace 1\ncomponent M\n" + header + runs);
    }
    LogReport check_whole_log(const std::string& text, const std::vector<std::string>& constants = {}) {
        std::istringstream in(text);
        reported.clear();
        return checker_->check_log(in, constants, [this](const RunReport& run) { reported.push_back(run); });
    }

    /// Checks the runs of a log with the numbers of the log in the carriers, as the command does.
    LogReport check_numbers(const std::string& runs) {
        const LogReport first = check_runs(runs);
        if (!first.related_numbers) return first;
        cause.clear();
        const auto exact =
            with_logged_numbers(project_.system, instantiation_, model_->boundary(), first.numbers, cause);
        if (!exact) return first;
        const auto model = load_model(exact->instantiation);
        TraceChecker checker(*model, {"M"}, limits_, project_.sources, {}, *exact);
        std::istringstream in("robochart-trace 1\ncomponent M\n" + runs);
        reported.clear();
        return checker.check_log(in, {}, [this](const RunReport& run) { reported.push_back(run); });
    }

    std::vector<RunReport> reported;
    std::string cause;  ///< reason why the carriers cannot contain the numbers of the log

private:
    std::unique_ptr<CyclicModel> load_model(const ir::Instantiation& instantiation) {
        std::string error;
        auto model = CyclicModel::load(project_.system, instantiation, component_, cycle_, limits_, project_.sources,
                                       project_.diagnostics, error);
        EXPECT_NE(model, nullptr) << error;
        return model;
    }

    test::Model project_;
    refine::Limits limits_;
    ir::ComponentRef component_;
    std::uint32_t cycle_;
    ir::Instantiation instantiation_;
    std::unique_ptr<CyclicModel> model_;
    std::unique_ptr<TraceChecker> checker_;
};

Replay aggregation_replay() {
    return {"corpus/aggregation", "module"};
}

/// If a header has other constants than those of the user, the log is refused and not compared.
TEST(Traces, AHeaderWithOtherConstantsIsRefused) {
    Replay replay("corpus/aggregation", "module");
    const std::string log = "robochart-trace 1\ncomponent M\nconst pace=3\nrun a\n";
    EXPECT_FALSE(replay.check_whole_log(log, {"pace=3"}).fault);
    for (const std::vector<std::string>& chosen : {std::vector<std::string>{}, {"pace=4"}, {"pace=3", "speed=1"}}) {
        const LogReport report = replay.check_whole_log(log, chosen);
        ASSERT_TRUE(report.fault);
        EXPECT_EQ(report.fault->fault.rule, &rules::log_of_other);
        EXPECT_EQ(report.runs, 0U);
    }
}

constexpr const char* start = "run a\nangularSpeed!-0.75 linearSpeed!-10.88 tock\n";

TEST(Traces, WhatTheModelDoesIsAccepted) {
    Replay replay = aggregation_replay();
    const LogReport report = replay.check_runs(std::string(start) +
                                               "seeRobot? angularSpeed!-5.02 linearSpeed!0 tock  // turns\n"
                                               "\n"
                                               "seeRobot? tock\n"
                                               "seeWall? angularSpeed!-0.75\nlinearSpeed!-10.88 tock tock\n"
                                               "run b\nseeWall? angularSpeed!-0.75 linearSpeed!-10.88 tock\n");
    EXPECT_FALSE(report.fault.has_value());
    EXPECT_EQ(report.runs, 2U);
    EXPECT_EQ(report.accepted, 2U) << (replay.reported.empty() ? "" : replay.reported.front().what);
    EXPECT_EQ(report.cycles, 6U);
}

/// Maximal progress (rule R3): the model has no cycle that ends before it makes its output.
TEST(Traces, AMissingOutputIsRejectedWhereTheCycleEnds) {
    Replay replay = aggregation_replay();
    const LogReport report = replay.check_runs(std::string(start) + "seeRobot? tock\ntock\n");
    ASSERT_EQ(report.rejected, 1U);
    const RunReport& run = replay.reported.at(0);
    EXPECT_EQ(run.what, "the end of the cycle");
    EXPECT_EQ(run.cycle, 2U);
    EXPECT_EQ(run.at_line, 5U);
    EXPECT_THAT(run.cycle_so_far, ElementsAre("seeRobot?"));
    EXPECT_THAT(run.allowed, ElementsAre(HasSubstr("angularSpeed = -5.02 (")));
    EXPECT_THAT(run.allowed.front(), HasSubstr("aggregation.rct:"));
    EXPECT_THAT(run.before, ElementsAre("angularSpeed!-0.75 linearSpeed!-10.88 tock"));
    EXPECT_THAT(run.elements, Contains(HasSubstr("aggregation.rct:")));
}

TEST(Traces, WrongExtraAndMisplacedOutputsAreRejected) {
    for (const auto& [cycle, what] : std::vector<std::pair<std::string, std::string>>{
             {"seeRobot? angularSpeed!-5.02 linearSpeed!-10.88 tock", "linearSpeed!-10.88"},  // wrong value
             {"seeRobot? linearSpeed!0 angularSpeed!-5.02 tock", "linearSpeed!0"},            // wrong order
             {"seeWall? angularSpeed!-5.02 linearSpeed!0 tock", "angularSpeed!-5.02"},        // without its input
             {"angularSpeed!-5.02 linearSpeed!0 tock", "angularSpeed!-5.02"},
             {"seeRobot? angularSpeed!-5.02 linearSpeed!0 linearSpeed!0 tock", "linearSpeed!0"},  // once too often
             {"angularSpeed!-0.75 linearSpeed!-10.88 tock", "angularSpeed!-0.75"}}) {
        Replay replay = aggregation_replay();
        EXPECT_EQ(replay.check_runs(std::string(start) + cycle + "\n").rejected, 1U) << cycle;
        ASSERT_EQ(replay.reported.size(), 1U) << cycle;
        EXPECT_EQ(replay.reported[0].what, what);
    }
}

/// Rule R1: every input is read once, before anything is written.
TEST(Traces, ReadsComeFirstAndOnce) {
    Replay replay = aggregation_replay();
    EXPECT_EQ(replay.check_runs("run a\nangularSpeed!-0.75 seeWall? linearSpeed!-10.88 tock\n").rejected, 1U);
    EXPECT_THAT(replay.reported.at(0).allowed, ElementsAre(HasSubstr("before anything is written")));
    EXPECT_EQ(replay.check_runs("run a\nseeWall? seeWall? angularSpeed!-0.75 linearSpeed!-10.88 tock\n").rejected, 1U);
}

/// traces(NF) is closed under prefixes: a log may end anywhere.
TEST(Traces, ALogMayEndInTheMiddleOfACycle) {
    Replay replay = aggregation_replay();
    EXPECT_EQ(replay.check_runs("run a\nangularSpeed!-0.75").accepted, 1U);
    EXPECT_EQ(replay.check_runs("run a\nseeWall?").accepted, 1U);
    EXPECT_EQ(replay.check_runs("run a\n").accepted, 1U);
    EXPECT_EQ(replay.check_runs("run a\nlinearSpeed!0").rejected, 1U);
}

TEST(Traces, WhatIsNotObservedMayHaveHappened) {
    Replay replay = aggregation_replay();
    const std::string seen = "run a\nlinearSpeed!-10.88 tock\nlinearSpeed!0 tock\n";
    EXPECT_EQ(replay.check_runs(seen, "unobserved angularSpeed! seeRobot?\n").accepted, 1U);
    EXPECT_EQ(replay.check_runs(seen, "unobserved angularSpeed!\n").rejected, 1U) << "nobody was seen";
    EXPECT_EQ(replay.check_runs(seen, "unobserved seeRobot?\n").rejected, 1U) << "angularSpeed was not written";
    // With these alternating speeds, the log is not a run of the model for any inputs.
    EXPECT_EQ(replay
                  .check_runs("run a\nlinearSpeed!-10.88 tock\nlinearSpeed!-10.88 tock\n",
                              "unobserved angularSpeed! seeRobot? seeWall?\n")
                  .rejected,
              1U);
    // An event that the header declares as unobserved must not be logged.
    EXPECT_TRUE(replay.check_runs("run a\nangularSpeed!-0.75 tock\n", "unobserved angularSpeed!\n").fault.has_value());
}

TEST(Traces, ALogMayStartLateAndLoseCycles) {
    Replay replay = aggregation_replay();
    const std::string turns = "seeRobot? angularSpeed!-5.02 linearSpeed!0 tock\n";
    const std::string drives = "seeWall? angularSpeed!-0.75 linearSpeed!-10.88 tock\n";
    EXPECT_EQ(replay.check_runs("run a\n" + turns).rejected, 1U);
    EXPECT_EQ(replay.check_runs("run a\nlate\n" + turns + drives).accepted, 1U);
    EXPECT_EQ(replay.check_runs("run a\nlate\n" + drives + "tock\n").accepted, 1U);
    EXPECT_EQ(replay.check_runs("run a\nlate\n" + drives + drives).rejected, 1U) << "it drives already";
    EXPECT_EQ(replay.check_runs(std::string(start) + "lost\n" + drives).accepted, 1U);
    EXPECT_EQ(replay.check_runs(std::string(start) + drives).rejected, 1U);
    EXPECT_TRUE(replay.check_runs(std::string(start) + "late\n").fault.has_value()) << "late is for the beginning";
}

/// Headings are only passed on (DataIndependence), so the check replaces values outside the finite instantiation by
/// values inside it.
TEST(Traces, ValuesThatAreOnlyPassedOnAreReplaced) {
    Replay replay("corpus/swarm_taxis", "module");
    const std::string first = "run a\nMoveForward! CheckIlluminationStatus! tock\n";
    const auto turn = [](const std::string& heard, const std::string& turned) {
        return "robotDetected? CalcAvoidanceHeading! tock\nheading?" + heard + " desiredTurningDegree!" + turned +
               " reached!false StartTurning!" + turned + " tock\n";
    };
    const LogReport good = replay.check_runs(first + turn("-84.377682133819", "-84.377682133819"));
    EXPECT_EQ(good.accepted, 1U) << (replay.reported.empty() ? "" : replay.reported[0].what);
    EXPECT_EQ(good.replaced, 3U);
    // The output differs from the input. Each run chooses its replacements at random, and only few of them are equal by
    // chance.
    std::string many;
    for (int i = 0; i < 20; ++i) many += first + turn("-84.377682133819", "84.377682133819");
    EXPECT_GE(replay.check_runs(many).rejected, 10U);
    // A value inside the finite instantiation is not replaced.
    EXPECT_EQ(replay.check_runs(first + turn("0.1", "0.2")).rejected, 1U);
}

/// A model that compares a distance with a constant, stores it, and sends it.
const char* const comparing = R"(
interface Ops { near(x : real) far() }
interface Events { event distance : real event name : Colour event limit : real }
enumeration Colour { Red Green }
stm M {
	requires Ops
	uses Events
	const edge : real = 0.5
	var d : real
	var c : Colour
	initial i
	state Far { }
	state Near { entry near(d) }
	state Done { entry far() }
	transition t0 { from i to Far }
	transition t1 { from Far to Near trigger distance?d condition d < edge }
	transition t2 { from Near to Done trigger name?c condition d > 0.3 /\ not d == 0.4 }
}
)";

/// The model compares distances only with its constants, so every logged distance has a verdict. The verdict is that of
/// the logged number, not of a rounded one. 0.30000001192092896 is the float next to 0.3, and greater.
TEST(Traces, NumbersThatAreComparedWithConstantsDecide) {
    Replay replay(test::ModelFolder(comparing).path(), "M");
    const auto verdict = [&](const std::string& heard, const std::string& then) {
        const LogReport report = replay.check_runs("run a\ntock\ndistance?" + heard + " " + then + "\n");
        EXPECT_EQ(report.inconclusive, 0U) << heard << ' ' << then;
        return report.accepted == 1;
    };
    for (const char* near : {"0.25", "0.4999999999999", "-17.125", "0.4", "0.3", "0"}) {
        EXPECT_TRUE(verdict(near, std::string("near!") + near + " tock")) << near;
        EXPECT_FALSE(verdict(near, "tock")) << near;
    }
    for (const char* far : {"0.5", "0.5000000000001", "1.7", "7.5", "100", "1e9"}) {
        EXPECT_TRUE(verdict(far, "tock")) << far;
        EXPECT_FALSE(verdict(far, std::string("near!") + far + " tock")) << far;
    }
    // The model stores this distance, and tests it later.
    for (const auto& [heard, done] : std::vector<std::pair<std::string, bool>>{{"0.30000001192092896", true},
                                                                               {"0.3", false},
                                                                               {"0.29999999", false},
                                                                               {"0.4", false},
                                                                               {"0.40000000001", true}}) {
        const std::string first = "near!" + heard + " tock\nname?Red ";
        EXPECT_EQ(verdict(heard, first + "far! tock"), done) << heard;
        EXPECT_EQ(verdict(heard, first + "tock"), !done) << heard;
    }
    // A different number on the same side of the constants is not the number that was read. Runs are rejected unless
    // both get equal replacements, which is rare.
    std::string many;
    for (int i = 0; i < 20; ++i) many += "run a\ntock\ndistance?0.31 near!0.32 tock\n";
    EXPECT_GE(replay.check_runs(many).rejected, 10U);
}

/// The model computes this output from its constants, so the logged value may have the rounding error of double or of
/// float.
TEST(Traces, OutputsBesideAConstantAreRounded) {
    Replay replay(test::ModelFolder(R"(
interface Ops { drive(v : real) }
interface Events { event distance : real }
stm M {
	requires Ops
	uses Events
	var d : real
	initial i
	state A { entry drive(0.3) }
	transition t0 { from i to A }
	transition t1 { from A to A trigger distance?d condition d < 0.5 }
}
)")
                      .path(),
                  "M");
    for (const char* rounded : {"0.3", "0.30000000000000004", "0.30000001192092896"})
        EXPECT_EQ(replay.check_runs(std::string("run a\ndrive!") + rounded + " tock\ndistance?0.125 drive!0.3 tock\n")
                      .accepted,
                  1U)
            << rounded;
    for (const char* wrong : {"0.31", "0.3001", "0.29999998"})
        EXPECT_EQ(replay.check_runs(std::string("run a\ndrive!") + wrong + " tock\n").rejected, 1U) << wrong;
}

/// A model that compares two readings, and stores one of them.
std::string nearer(const std::string& condition) {
    return R"(
interface Ops { near(x : real) }
interface Events { event distance : real event limit : real }
stm M {
	requires Ops
	uses Events
	var d : real
	var l : real
	initial i
	state Far { }
	transition t0 { from i to Far }
	transition t1 { from Far to Far trigger limit?l }
	transition t2 { from Far to Far trigger distance?d condition )" +
           condition + R"( action near(d) }
}
)";
}

/// The verdict of a cycle that reads a distance after a limit, with the output and without it: 'a'ccepted, 'r'ejected,
/// 'i'nconclusive.
std::string verdicts(Replay& replay, const std::string& limit, const std::string& distance) {
    std::string result;
    for (const std::string& output : {" near!" + distance, std::string()}) {
        const LogReport report =
            replay.check_numbers("run a\ntock\nlimit?" + limit + " tock\ndistance?" + distance + output + " tock\n");
        result += report.accepted == 1 ? 'a' : report.rejected == 1 ? 'r' : 'i';
    }
    return result;
}

/// Two readings are compared as they were logged, for all sizes: floats are not rounded to decimals.
TEST(Traces, ReadingsThatAreComparedWithEachOtherDecide) {
    Replay replay(test::ModelFolder(nearer("d < l")).path(), "M");
    for (const auto& [limit, distance, near] :
         std::vector<std::tuple<std::string, std::string, bool>>{{"2", "1", true},
                                                                 {"1", "2", false},
                                                                 {"2", "1.5", true},
                                                                 {"1.5", "1.5", false},
                                                                 {"0.1", "0.30000001192092896", false},
                                                                 {"0.30000001192092896", "0.3", true},
                                                                 {"0.3", "0.30000001192092896", false},
                                                                 {"0.30000000000000004", "0.3", true},
                                                                 {"-17.25", "-17.250001", true},
                                                                 {"123456.789", "123456.7891", false}})
        EXPECT_EQ(verdicts(replay, limit, distance), near ? "ar" : "ra") << limit << ' ' << distance;
}

/// The model is evaluated only in the states of the log: compilation would visit a power of the number of readings.
TEST(Traces, ManyReadingsDecide) {
    Replay replay(test::ModelFolder(nearer("d < l")).path(), "M");
    std::string good = "run a\ntock\nlimit?75.5 tock\n";
    for (int i = 0; i < 150; ++i) {
        const std::string reading = std::to_string(i * 37 % 150) + ".25";
        good += "distance?" + reading + (i * 37 % 150 <= 75 ? " near!" + reading : "") + " tock\n";
    }
    EXPECT_EQ(replay.check_numbers(good).accepted, 1U) << replay.cause;
    EXPECT_EQ(replay.check_numbers(good + "distance?76.25 near!76.25 tock\n").rejected, 1U) << replay.cause;
}

/// `d - l > 0.5` where the difference is not a number of the finite instantiation: it is not clipped.
TEST(Traces, DifferencesOfReadingsDecide) {
    Replay replay(test::ModelFolder(nearer("l - d > 0.5")).path(), "M");
    for (const auto& [limit, distance, near] :
         std::vector<std::tuple<std::string, std::string, bool>>{{"0", "2", false},
                                                                 {"2", "0", true},
                                                                 {"7.25", "6.5", true},
                                                                 {"7.25", "6.75", false},
                                                                 {"1e6", "0.125", true},
                                                                 {"0.800000011920929", "0.30000001192092896", false},
                                                                 {"0.9000000357627869", "0.30000001192092896", true}})
        EXPECT_EQ(verdicts(replay, limit, distance), near ? "ar" : "ra") << limit << ' ' << distance;
}

/// The readings are in the finite instantiation and their difference is not: -2 - 2 is not clipped to -2.
TEST(Traces, DifferencesOutsideTheInstantiationAreNotClipped) {
    Replay replay(test::ModelFolder(nearer("l - d > -2.5")).path(), "M");
    EXPECT_EQ(verdicts(replay, "-2", "2"), "ra");
    EXPECT_EQ(verdicts(replay, "2", "-2"), "ar");
    EXPECT_EQ(verdicts(replay, "-2", "0"), "ar");
}

/// The value of an earlier cycle, in a sum with three readings.
TEST(Traces, SumsOfThreeReadingsDecide) {
    Replay replay(test::ModelFolder(R"(
interface Ops { jump() }
interface Events { event level : real }
stm M {
	requires Ops
	uses Events
	var a : real
	var b : real
	var c : real
	initial i
	state S { }
	transition t0 { from i to S }
	transition t1 { from S to S trigger level?c condition c + a <= b + b action a = b ; b = c }
	transition t2 { from S to S trigger level?c condition c + a > b + b action jump() ; a = b ; b = c }
}
)")
                      .path(),
                  "M");
    // the second differences of 0 0 1.25 2.5 3.5 4.75 are 1.25 0 -0.25 0.25
    const std::string good =
        "run a\ntock\nlevel?1.25 jump! tock\nlevel?2.5 tock\nlevel?3.5 tock\nlevel?4.75 jump! tock\n";
    EXPECT_EQ(replay.check_numbers(good).accepted, 1U) << replay.cause;
    EXPECT_EQ(replay.check_numbers("run a\ntock\nlevel?1.25 jump! tock\nlevel?2.5 jump! tock\n").rejected, 1U);
    EXPECT_EQ(
        replay.check_numbers("run a\ntock\nlevel?1.25 jump! tock\nlevel?2.5 tock\nlevel?3.75 jump! tock\n").rejected,
        1U);
}

/// A counter far beyond the numbers of the model counts back exactly: a clipped one would be low too early. After ten
/// steps up and five down, five are left.
TEST(Traces, CountersAreNotClipped) {
    Replay replay(test::ModelFolder(R"(
interface Events { event up event down event high : boolean }
stm M {
	uses Events
	var n : int
	initial i
	state S { }
	transition t0 { from i to S action n = 0 }
	transition t1 { from S to S trigger up action n = n + 1 ; high ! ( n > 2 ) }
	transition t2 { from S to S trigger down action n = n - 1 ; high ! ( n > 2 ) }
}
)")
                      .path(),
                  "M");
    std::string ups = "run a\ntock\nup? high!false tock\nup? high!false tock\n";
    for (int i = 3; i <= 10; ++i) ups += "up? high!true tock\n";
    std::string downs;
    for (int i = 9; i >= 3; --i) downs += "down? high!true tock\n";
    EXPECT_EQ(replay.check_runs(ups + downs + "down? high!false tock\n").accepted, 1U);
    EXPECT_EQ(replay.check_runs(ups + downs + "down? high!true tock\n").rejected, 1U);
    EXPECT_EQ(replay.check_runs(ups + "down? high!false tock\n").rejected, 1U);
    // A log that starts late does not show the counter, which may have any value. The other runs are decided.
    const LogReport late = replay.check_runs("run b\nlate\nup? high!true tock\n" + ups);
    EXPECT_EQ(late.inconclusive, 1U);
    EXPECT_EQ(late.accepted, 1U);
    EXPECT_THAT(replay.reported.at(0).reason, HasSubstr("too many states"));
}

/// Returns a scan of `length` readings of 7.25 with one other reading.
std::string scan_word(std::size_t length, std::size_t place, const std::string& reading) {
    std::string text = "scan?<";
    for (std::size_t i = 1; i <= length; ++i) text += (i > 1 ? "," : "") + (i == place ? reading : "7.25");
    return text + ">";
}

/// The double before 0.3 is 0.29999999999999993, and the one after it is 0.30000000000000004. A float sensor measures
/// 0.30000001192092896 for 0.3, which is greater.
TEST(Traces, ScansAreDecidedByTheirWindows) {
    Replay replay(test::ModelFolder(R"(
import sequence_toolkit::*
import set_toolkit::*
import relation_toolkit::*
interface Events { event scan : Seq(real) event distance : real event stop event go event clear }
stm M {
	uses Events
	var s : Seq(real)
	var d : real
	initial i
	state S { }
	junction k
	transition t0 { from i to S }
	transition t1 { from S to k trigger scan ? s }
	transition t2 { from k to S condition min(ran(extract([2, 3], s))) < 0.3 action stop }
	transition t3 { from k to S condition min(ran(extract([2, 3], s))) >= 0.3 /\ min(ran(s)) < 0.5 action go }
	transition t4 { from k to S condition min(ran(extract([2, 3], s))) >= 0.3 /\ min(ran(s)) >= 0.5 action clear }
	transition t5 { from k to S condition size(s) < 2 }
	transition t6 { from S to S trigger distance ? d condition d < 0.7 action stop }
}
)")
                      .path(),
                  "M");
    const std::vector<std::pair<std::string, std::string>> expected{
        {scan_word(360, 3, "0.29999999999999993"), "stop!"},
        {scan_word(360, 2, "0.3"), "go!"},
        {scan_word(360, 3, "0.30000001192092896"), "go!"},
        {scan_word(360, 4, "0.1"), "go!"},
        {scan_word(5000, 4999, "0.49999999999999994"), "go!"},
        {scan_word(5000, 4999, "0.5"), "clear!"},
        {scan_word(2, 2, "-1e300"), "stop!"},
        {"scan?<0.1>", ""},
        {"scan?<>", ""},
        {"distance?0.6999", "stop!"},
        {"distance?0.7", ""},
    };
    for (const auto& [input, output] : expected) {
        SCOPED_TRACE(input.substr(0, 40) + " " + output);
        for (const std::string other : {"", "stop!", "go!", "clear!"}) {
            const LogReport report = replay.check_runs("run a\ntock\n" + input + " " + other + " tock\n");
            EXPECT_EQ(report.accepted, other == output ? 1U : 0U) << other;
            EXPECT_EQ(report.rejected, other == output ? 0U : 1U) << other;
        }
    }
}

/// A component that sends scans on needs them, and scans longer than those of the model leave the run undecided.
TEST(Traces, ScansThatAreSentOnHaveNoClasses) {
    Replay replay(test::ModelFolder(R"(
import sequence_toolkit::*
import set_toolkit::*
import relation_toolkit::*
interface Events { event scan : Seq(nat) event echo : Seq(nat) }
stm M {
	uses Events
	var s : Seq(nat)
	initial i
	state S { }
	transition t0 { from i to S }
	transition t1 { from S to S trigger scan ? s condition min(ran(extract([1, 2], s))) < 1 action echo ! s }
}
)")
                      .path(),
                  "M");
    EXPECT_EQ(replay.check_runs("run a\ntock\nscan?<0,1> echo!<0,1> tock\n").accepted, 1U);
    EXPECT_EQ(replay.check_runs("run a\ntock\nscan?<0,1> echo!<0,0> tock\n").rejected, 1U);
    EXPECT_EQ(replay.check_runs("run a\ntock\nscan?<0,1,1,1> echo!<0,1,1,1> tock\n").inconclusive, 1U);
}

/// 1.1 - 0.6 is 0.5, but 0.5000000000000001 in the arithmetic of double: a robot may do either. The exact answer is
/// accepted, the other one is not rejected.
TEST(Traces, SumsWithinTheRoundingErrorAreNotRejected) {
    ASSERT_GT(1.1 - 0.6, 0.5);
    Replay replay(test::ModelFolder(nearer("l - d > 0.5")).path(), "M");
    EXPECT_EQ(verdicts(replay, "1.1", "0.6"), "ia");
    ASSERT_EQ(replay.check_numbers("run a\ntock\nlimit?1.1 tock\ndistance?0.6 near!0.6 tock\n").inconclusive, 1U);
    EXPECT_THAT(replay.reported.at(0).reason, HasSubstr("1.1 - 0.6 > 0.5"));
}

/// A model that also computes with readings leaves the run undecided, as do more numbers than the carriers can take.
TEST(Traces, ComputedNumbersLeaveTheRunUndecided) {
    Replay doubled(test::ModelFolder(nearer("d * 2 < l")).path(), "M");
    EXPECT_EQ(verdicts(doubled, "2.5", "1.5"), "ii");
    EXPECT_THAT(doubled.reported.at(0).reason, HasSubstr("2.5 is outside the finite instantiation"));
    Replay replay(test::ModelFolder(nearer("d < l")).path(), "M");
    std::string many = "run a\ntock\n";
    for (std::size_t i = 0; i <= most_logged_numbers; ++i) many += "limit?" + std::to_string(i) + ".5 tock\n";
    EXPECT_EQ(replay.check_numbers(many).inconclusive, 1U);
    EXPECT_THAT(replay.cause, HasSubstr("more than 1000 different numbers"));
}

/// Whole numbers are compared as they are; naturals are not subtracted, because the result may be negative.
TEST(Traces, WholeNumbersAreComparedWithEachOther) {
    const auto model = [](const std::string& type, const std::string& condition) {
        return "interface Ops { more() }\ninterface Events { event count : " + type +
               " }\nstm M { requires Ops uses Events var a : " + type + " var b : " + type +
               " initial i state S { } transition t0 { from i to S }\n"
               "transition t1 { from S to S trigger count?a condition " +
               condition + " action more() ; b = a } }\n";
    };
    Replay integers(test::ModelFolder(model("int", "a - b > 10")).path(), "M");
    EXPECT_EQ(
        integers.check_numbers("run a\ntock\ncount?1000 more! tock\ncount?1010 tock\ncount?1011 more! tock\n").accepted,
        1U);
    EXPECT_EQ(integers.check_numbers("run a\ntock\ncount?1000 more! tock\ncount?1010 more! tock\n").rejected, 1U);
    EXPECT_EQ(integers.check_numbers("run a\ntock\ncount?-1000 tock\n").accepted, 1U);
    Replay naturals(test::ModelFolder(model("nat", "a > b")).path(), "M");
    EXPECT_EQ(naturals.check_numbers("run a\ntock\ncount?1000 more! tock\ncount?999 tock\n").accepted, 1U);
    EXPECT_EQ(naturals.check_numbers("run a\ntock\ncount?1000 more! tock\ncount?999 more! tock\n").rejected, 1U);
    Replay differences(test::ModelFolder(model("nat", "a - b > 10")).path(), "M");
    EXPECT_EQ(differences.check_numbers("run a\ntock\ncount?1000 more! tock\n").inconclusive, 1U);
}

const char* const carrier = R"(
enumeration Colour { Red Green }
datatype Pose { x : real near : boolean }
interface Ops { go(p : Pose) follow(path : Seq(real)) paint(s : Set(Colour)) label(f : boolean -> Colour) }
interface Events { event pose : Pose event path : Seq(real) event seen : Set(Colour) event kinds : boolean -> Colour }
stm M {
	requires Ops
	uses Events
	var p : Pose
	var q : Seq(real)
	var s : Set(Colour)
	var f : boolean -> Colour
	initial i
	state A { }
	transition t0 { from i to A }
	transition t1 { from A to A trigger pose?p action go(p) }
	transition t2 { from A to A trigger path?q action follow(q) }
	transition t3 { from A to A trigger seen?s action paint(s) }
	transition t4 { from A to A trigger kinds?f action label(f) }
}
)";

/// One value has several spellings. Blanks, the order and duplicates in sets, and names as in CSP may differ.
TEST(Traces, ValuesWithPartsAreReadByTheirType) {
    Replay replay(test::ModelFolder(carrier).path(), "M");
    for (const char* cycle :
         {"pose?(1,true) go!(1,true)", "pose?( 1.0 , true ) go!(1,true)", "path?<> follow!<>",
          "path?<2,0> follow!<2, 0>", "seen?{Red,Green} paint!{Green,Red,Green}", "seen?{Colour_Red} paint!{Red}",
          "seen?{} paint!{ }", "kinds?{(true,Red),(false,Green)} label!{(false,Green),(true,Red)}"})
        EXPECT_EQ(replay.check_runs(std::string("run a\ntock\n") + cycle + " tock\n").accepted, 1U) << cycle;
    for (const char* cycle :
         {"pose?(1,true) go!(1,false)", "path?<2,0> follow!<0,2>", "path?<2,0> follow!<2>",
          "seen?{Red,Green} paint!{Green}", "kinds?{(true,Red),(false,Green)} label!{(true,Red),(false,Red)}"})
        EXPECT_EQ(replay.check_runs(std::string("run a\ntock\n") + cycle + " tock\n").rejected, 1U) << cycle;
}

/// The model only passes reals on. A real outside the carrier is replaced by one of the carrier, consistently in all
/// composite values that contain it. A sequence longer than the model's maximum is outside for all elements,
/// and so is a partial function.
TEST(Traces, PartsOutsideTheFiniteInstantiation) {
    Replay replay(test::ModelFolder(carrier).path(), "M");
    const std::string first = "run a\ntock\n";
    const LogReport good =
        replay.check_runs(first + "pose?(0.31,true) path?<0.31,7> go!(0.31,true) follow!<0.31,7> tock\n");
    EXPECT_EQ(good.accepted, 1U) << (replay.reported.empty() ? "" : replay.reported[0].what);
    EXPECT_EQ(good.replaced, 4U);
    std::string many;
    for (int i = 0; i < 20; ++i) many += first + "path?<0.31,7> follow!<7,0.31> tock\n";
    EXPECT_GE(replay.check_runs(many).rejected, 10U);
    EXPECT_EQ(replay.check_runs(first + "pose?(0.31,true) go!(0.31,false) tock\n").rejected, 1U);
    EXPECT_EQ(replay.check_runs(first + "path?<0,0,0> follow!<0,0,0> tock\n").inconclusive, 1U);
    EXPECT_THAT(replay.reported.at(0).reason, HasSubstr("<0,0,0> is outside the finite instantiation"));
    EXPECT_EQ(replay.check_runs(first + "kinds?{(true,Red)} label!{(true,Red)} tock\n").inconclusive, 1U);
}

/// Converting the elements of a sequence is an operation on numbers, so the numbers are not only passed on.
TEST(Traces, PartsThatAreConvertedAreNotOnlyPassedOn) {
    Replay replay(test::ModelFolder(R"(
interface Ops { follow(path : Seq(real)) }
interface Events { event path : Seq(nat) }
stm M {
	requires Ops
	uses Events
	var q : Seq(nat)
	initial i
	state A { }
	transition t0 { from i to A }
	transition t1 { from A to A trigger path?q action follow(q) }
}
)")
                      .path(),
                  "M");
    EXPECT_EQ(replay.check_runs("run a\ntock\npath?<2> follow!<2> tock\n").accepted, 1U);
    EXPECT_EQ(replay.check_runs("run a\ntock\npath?<7> follow!<7> tock\n").inconclusive, 1U);
}

TEST(Traces, TerminationEndsARun) {
    Replay replay(test::ModelFolder(R"(
interface Events { event stop }
stm M {
	uses Events
	initial i
	state On { }
	final f
	transition t0 { from i to On }
	transition t1 { from On to f trigger stop }
}
)")
                      .path(),
                  "M");
    EXPECT_EQ(replay.check_runs("run a\ntock\nstop? terminate\n").accepted, 1U);
    EXPECT_EQ(replay.check_runs("run a\ntock\nstop? tock\n").rejected, 1U);
    EXPECT_THAT(replay.reported.at(0).allowed, ElementsAre("termination"));
    EXPECT_EQ(replay.check_runs("run a\ntock\nterminate\n").rejected, 1U);
    EXPECT_EQ(replay.check_runs("run a\nstop? terminate tock\n").rejected, 1U);
    EXPECT_THAT(replay.reported.at(0).allowed, ElementsAre("nothing: it has terminated"));
}

/// A cycle of two time units ends with two tocks, and nothing comes between them.
TEST(Traces, CyclesMayBeLonger) {
    Replay replay("corpus/aggregation", "module", 2);
    const std::string first = "run a\nangularSpeed!-0.75 linearSpeed!-10.88 tock tock\n";
    EXPECT_EQ(replay.check_runs(first, "cycle 2\n").accepted, 1U);
    EXPECT_EQ(
        replay.check_runs("run a\nangularSpeed!-0.75 linearSpeed!-10.88 tock seeRobot? tock\n", "cycle 2\n").rejected,
        1U);
    EXPECT_EQ(replay.check_runs(first).fault->fault.rule, &rules::log_of_other)
        << "RC-L04: the header says cycles of one";
}

std::string code_of(const LogReport& report) {
    return report.fault ? std::string(report.fault->fault.rule->code) : "";
}

/// Tests each rule for logs with a faulty log and a similar correct one.
TEST(Traces, LogsThatCannotBeReadAreReportedWithTheirPlace) {
    Replay replay = aggregation_replay();
    EXPECT_EQ(code_of(replay.check_whole_log("")), "RC-L01");
    EXPECT_EQ(code_of(replay.check_whole_log("hello\n")), "RC-L01");
    EXPECT_EQ(code_of(replay.check_whole_log("robochart-trace 2\ncomponent M\n")), "RC-L01");
    EXPECT_EQ(code_of(replay.check_whole_log("robochart-trace 1\nrun a\n")), "RC-L01") << "no component";
    EXPECT_EQ(code_of(replay.check_whole_log("// by hand\nrobochart-trace 1\ncomponent M\n")), "");
    EXPECT_EQ(code_of(replay.check_whole_log("\xEF\xBB\xBFrobochart-trace 1\ncomponent M\n")), "");
    EXPECT_EQ(code_of(replay.check_runs("tock\n")), "RC-L01") << "no run";
    EXPECT_EQ(code_of(replay.check_runs("run a\nhello\n")), "RC-L01");
    EXPECT_EQ(code_of(replay.check_runs("run a\n", "cycle 0\n")), "RC-L01");
    EXPECT_EQ(code_of(replay.check_runs("run a\n", "cycle many\n")), "RC-L01");
    EXPECT_EQ(code_of(replay.check_runs(std::string("run a\nto\0ck\n", 12))), "RC-L01");
    EXPECT_EQ(code_of(replay.check_runs("run a\n" + std::string(2U << 20U, 'x'))), "RC-L01");
    EXPECT_EQ(code_of(replay.check_runs("run a\nseeNobody? tock\n")), "RC-L02");
    EXPECT_EQ(code_of(replay.check_runs("run a\nseeWall! tock\n")), "RC-L02") << "an input is no output";
    EXPECT_EQ(code_of(replay.check_runs("run a\n", "unobserved speed!\n")), "RC-L02");
    EXPECT_EQ(code_of(replay.check_runs("run a\nseeWall?3 tock\n")), "RC-L03");
    EXPECT_EQ(code_of(replay.check_runs("run a\nangularSpeed! tock\n")), "RC-L03");
    EXPECT_EQ(code_of(replay.check_runs("run a\nangularSpeed!fast tock\n")), "RC-L03");
    EXPECT_EQ(code_of(replay.check_runs("run a\nangularSpeed!1!2 tock\n")), "RC-L03");
    EXPECT_EQ(code_of(replay.check_whole_log("robochart-trace 1\ncomponent Other\n")), "RC-L04");
    const LogReport report = replay.check_runs("run a\n  seeWall? seeNobody? tock\n");
    EXPECT_EQ(report.fault->line, 4U);
    EXPECT_EQ(report.fault->fault.column, 11U);
    EXPECT_EQ(report.fault->fault.length, 9U);
}

/// RC-L03 describes the type and points to the part that is not a value of it.
TEST(Traces, PartsThatAreNoneOfTheirTypeAreReportedWithTheirPlace) {
    Replay replay(test::ModelFolder(carrier).path(), "M");
    for (const auto& [word, expected, column] : std::vector<std::tuple<const char*, const char*, unsigned>>{
             {"pose?(1,yes)", "true or false", 8},
             {"pose?(x,true)", "a number", 6},
             {"pose?(inf,true)", "a number", 6},
             {"pose?(1)", "2 values `(...,...)`", 5},
             {"pose?1", "2 values `(...,...)`", 5},
             {"pose?(1,true", "2 values `(...,...)`", 5},
             {"pose?(1,true)2", "2 values `(...,...)`", 5},
             {"path?<1,>", "a number", 8},
             {"path?(1,2)", "a sequence `<...,...>`", 5},
             {"path?<1 2>", "a sequence `<...,...>`", 5},
             {"seen?<Red>", "a set `{...,...}`", 5},
             {"seen?{Blue}", "a literal of Colour", 6},
             {"kinds?{true,Red}", "pairs `{(...,...),...}`", 6}}) {
        const LogReport report = replay.check_runs(std::string("run a\ntock\n") + word + "\n");
        ASSERT_EQ(code_of(report), "RC-L03") << word;
        EXPECT_EQ(report.fault->fault.arguments.at(1), expected) << word;
        EXPECT_EQ(report.fault->fault.column, column) << word;
    }
}

/// A fault in a later line is reported even if an earlier run already has a verdict.
TEST(Traces, LogsAreReadToTheirEnd) {
    Replay replay = aggregation_replay();
    const LogReport report = replay.check_runs("run a\nlinearSpeed!0 tock\nseeNobody?\n");
    EXPECT_EQ(code_of(report), "RC-L02");
}

/// Returns the first module, or the first controller or machine if there is none.
ir::ComponentRef largest_component(const test::Model& project) {
    if (!project.system.modules.empty()) return project.first_module();
    if (!project.system.controllers.empty()) return project.first_controller();
    return project.machine_named(project.system.machines.front().name);
}

/// The interface that is derived from the model is the one that the generated code declares.
TEST(Traces, TheInterfaceOfTheModelIsThatOfTheCode) {
    for (const char* folder : {"corpus/aggregation", "corpus/swarm_taxis", "tests/conformance/models/nested",
                               "tests/conformance/models/team", "tests/conformance/models/parcels"}) {
        test::Model project(folder);
        const ir::ComponentRef ref = largest_component(project);
        test::Bench bench(project, ref);
        const Interface code = bench.interface();
        const auto model =
            model_interface(project.system, project.instantiation, ref, bench.script().provenance, project.diagnostics);
        ASSERT_TRUE(model.has_value()) << folder;
        EXPECT_EQ(model->interface.component, code.component);
        EXPECT_EQ(model->interface.scale, code.scale);
        EXPECT_EQ(model->interface.blocked, code.blocked);
        ASSERT_EQ(model->interface.inputs.size(), code.inputs.size()) << folder;
        ASSERT_EQ(model->interface.outputs.size(), code.outputs.size()) << folder;
        for (std::size_t i = 0; i < code.inputs.size(); ++i) {
            EXPECT_EQ(model->interface.inputs[i].name, code.inputs[i].name);
            EXPECT_EQ(model->interface.inputs[i].values, code.inputs[i].values);
            EXPECT_EQ(model->interface.inputs[i].texts, code.inputs[i].texts);
            EXPECT_EQ(model->interface.inputs[i].carrier.kind, code.inputs[i].carrier.kind);
        }
        for (std::size_t o = 0; o < code.outputs.size(); ++o) {
            EXPECT_EQ(model->interface.outputs[o].name, code.outputs[o].name);
            EXPECT_EQ(model->interface.outputs[o].arguments.size(), code.outputs[o].arguments.size());
        }
    }
}

}  // namespace
}  // namespace robochart::conformance
