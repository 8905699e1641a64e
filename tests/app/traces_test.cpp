// SPDX-License-Identifier: Apache-2.0
// Tests `simulate --log` and `conform --traces`: runs of generated controllers are runs of their model, and runs of
// altered controllers are not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "tests/contents.hpp"

namespace robochart::app::traces_test {
namespace {

using tests::read_contents;

namespace fs = std::filesystem;
using testing::Folder;
using ::testing::HasSubstr;
using testing::repository;
using testing::run;

/// Copies a case study and its scenario into the folder, with one replacement in the model.
void change(const Folder& folder, const std::string& study, const std::string& what, const std::string& with) {
    std::string model = read_contents(repository("corpus/" + study + "/" + study + ".rct"));
    const std::size_t at = model.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    model.replace(at, what.size(), with);
    std::ofstream(folder / (study + ".rct")) << model;
    fs::copy(repository("corpus/" + study + "/" + study + ".scenario"), folder / (study + ".scenario"));
}

TEST(Traces, EveryRobotOfBothCaseStudiesRunsAsItsModel) {
    for (const char* study : {"aggregation", "swarm_taxis"}) {
        const Folder folder;
        const std::string scenario = repository(std::string("corpus/") + study + "/" + study + ".scenario");
        const auto simulated = run({"simulate", scenario, "--trials", "2", "--no-pictures", "--log", folder / "logs"});
        ASSERT_NE(simulated.exit, 2) << simulated.err;
        ASSERT_TRUE(fs::exists(folder / "logs/trial-02/robot-19.trace"));
        const auto checked = run({"conform", repository(std::string("corpus/") + study), "--traces", folder / "logs"});
        EXPECT_EQ(checked.exit, 0) << checked.out << checked.err;
        EXPECT_THAT(checked.out, HasSubstr("40 runs in 40 logs")) << study;
        EXPECT_THAT(checked.out, HasSubstr("40 accepted, 0 rejected, 0 inconclusive")) << study;
    }
}

/// A simulation writes the same logs as text and as MCAP files, which the model accepts.
TEST(Traces, LogsOfASimulationMayBeMcapFiles) {
    const Folder folder;
    const std::string scenario = repository("corpus/aggregation/aggregation.scenario");
    for (const char* format : {"text", "mcap"})
        ASSERT_NE(run({"simulate", scenario, "--trials", "1", "--no-pictures", "--log", folder / format, "--log-format",
                       format})
                      .exit,
                  2);
    ASSERT_TRUE(fs::exists(folder / "mcap/trial-01/robot-19.mcap"));
    for (const char* format : {"text", "mcap"}) {
        const auto checked = run({"conform", repository("corpus/aggregation"), "--traces", folder / format});
        EXPECT_EQ(checked.exit, 0) << checked.out << checked.err;
        EXPECT_THAT(checked.out, HasSubstr("20 accepted, 0 rejected, 0 inconclusive")) << format;
    }
    // the MCAP file has the words of the text
    const std::string text = read_contents(folder / "text/trial-01/robot-00.trace");
    const std::string words = text.substr(text.find("component "));
    EXPECT_THAT(read_contents(folder / "mcap/trial-01/robot-00.mcap"), HasSubstr(words.substr(0, 200)));
}

/// A log of readings that the model compares with each other decides, and says why if it does not.
TEST(Traces, ReadingsThatAreComparedWithEachOtherDecide) {
    const Folder folder({std::pair<std::string, std::string>(
        "m.rct",
        "interface Drive { approach(x : real) hold() }\n"
        "stm M { requires Drive event distance : real event other : real var d : real var o : real var last : real "
        "initial i state S { } junction k transition t0 { from i to S } transition t1 { from S to S trigger other ? o "
        "}\n"
        "transition t2 { from S to k trigger distance ? d }\n"
        "transition t3 { from k to S condition last - d > 0.5 \\/ d < o action approach(d) ; last = d }\n"
        "transition t4 { from k to S condition not (last - d > 0.5 \\/ d < o) action hold() ; last = d } }\n")});
    const auto checked = [&](const std::string& runs) {
        std::ofstream(folder / "a.trace") << "robochart-trace 1\ncomponent M\n" << runs;
        return run({"conform", folder / "m.rct", "--traces", folder / "a.trace"});
    };
    const std::string first = "run a\nother?1.7999999523162842 tock\ndistance?2.5 hold! tock\n";
    const std::string good = first +
                             "distance?1.899999976158142 approach!1.899999976158142 tock\n"
                             "distance?1.7999999523162842 hold! tock\n"
                             "distance?1.7 approach!1.7 tock\n";
    const auto accepted = checked(good + good);
    EXPECT_EQ(accepted.exit, 0) << accepted.out << accepted.err;
    EXPECT_THAT(accepted.out, HasSubstr("2 accepted, 0 rejected, 0 inconclusive"));
    const auto rejected = checked(good + first + "distance?1.899999976158142 hold! tock\n");
    EXPECT_EQ(rejected.exit, 1) << rejected.out << rejected.err;
    EXPECT_THAT(rejected.out, HasSubstr("allowed    approach(1.899999976158142)"));
    std::string many = "run a\n";
    for (int i = 0; i < 1500; ++i) many += "other?" + std::to_string(i) + ".25 tock\n";
    const auto open = checked(many);
    EXPECT_EQ(open.exit, 3) << open.out << open.err;
    EXPECT_THAT(open.out, HasSubstr("the log has more than 1000 different numbers"));
}

/// Logs contain values that are not numbers of any model, and numbers near the limits of `double`.
TEST(Traces, NumbersThatAreNoneAreRefusedAndExtremeOnesAreCompared) {
    const std::string model =
        "interface Plant { heat() rest() }\n"
        "stm T { requires Plant event degrees : real event shown : real var t : real initial i\n"
        "state R { entry rest() } state H { entry heat() ; shown ! t } junction k transition t0 { from i to R }\n"
        "transition t1 { from R to k trigger degrees ? t } transition t2 { from H to k trigger degrees ? t }\n"
        "transition t3 { from k to H condition t < 19.5 } transition t4 { from k to R condition t >= 19.5 } }\n";
    const Folder folder({std::pair<std::string, std::string>("m.rct", model)});
    const auto checked = [&](const std::string& number) {
        std::ofstream(folder / "a.trace") << "robochart-trace 1\ncomponent T\nrun a\nrest! tock\ndegrees?" << number
                                          << " heat! shown!" << number << " tock\n";
        return run({"conform", folder / "m.rct", "--traces", folder / "a.trace"});
    };
    for (const char* number : {"nan", "NaN", "inf", "-inf", "1e309", "0x10"}) {
        const auto ran = checked(number);
        EXPECT_EQ(ran.exit, 2) << number;
        EXPECT_THAT(ran.out + ran.err, HasSubstr(std::string("degrees carries a number, found `") + number + "`"));
        EXPECT_THAT(ran.out + ran.err, HasSubstr("a.trace:5:9"));
    }
    for (const char* number : {"-0.0", "-1e308", "1e-308", "19.4999"}) EXPECT_EQ(checked(number).exit, 0) << number;
    for (const char* number : {"1e308", "19.5"}) {
        const auto ran = checked(number);
        EXPECT_EQ(ran.exit, 1) << number << ran.err;
        EXPECT_THAT(ran.out, HasSubstr("allowed    rest()")) << number;
    }
}

/// The controllers are generated from altered models, so the original model rejects their logs.
TEST(Traces, ChangedControllersAreFoundOut) {
    struct Change {
        const char* study;
        const char* what;
        const char* with;
        const char* reported;
    };
    const std::vector<Change> changes = {
        {"aggregation", "from i to S1", "from i to S2", "aggregation.rct"},
        {"aggregation", "RotateClockwise(-5.02)", "RotateClockwise(-0.75)", "angularSpeed = -5.02"},
        {"swarm_taxis", "since(T) >= 25", "since(T) >= 24", "swarm_taxis.rct"},
        {"swarm_taxis", "reached = false; StartTurning(degree)", "StartTurning(degree); reached = false",
         "reached = false"}};
    for (const Change& changed : changes) {
        const Folder folder;
        change(folder, changed.study, changed.what, changed.with);
        const auto simulated = run({"simulate", folder / (std::string(changed.study) + ".scenario"), "--trials", "1",
                                    "--no-pictures", "--log", folder / "logs"});
        ASSERT_NE(simulated.exit, 2) << simulated.err;
        const auto checked =
            run({"conform", repository(std::string("corpus/") + changed.study), "--traces", folder / "logs"});
        EXPECT_EQ(checked.exit, 1) << changed.with << checked.out << checked.err;
        EXPECT_THAT(checked.out, HasSubstr("rejected")) << changed.with;
        EXPECT_THAT(checked.out, HasSubstr(changed.reported)) << changed.with;
    }
}

TEST(Monitors, LetTrueControllersRun) {
    for (const char* study : {"aggregation", "swarm_taxis"}) {
        const std::string scenario = repository(std::string("corpus/") + study + "/" + study + ".scenario");
        const auto ran = run({"simulate", scenario, "--no-pictures", "--monitor", "--trials", "2"});
        EXPECT_EQ(ran.err.find("RC-M12"), std::string::npos) << ran.err;
        EXPECT_THAT(ran.out, HasSubstr("40 robots watched\n")) << "all, to the end: " << ran.out;
    }
}

TEST(TestSuites, AreEmittedAndAreRunsOfTheModel) {
    const Folder folder;
    const auto emitted =
        run({"emit", "tests", repository("corpus/aggregation"), "--extra-states", "1", "--out", folder / "out"});
    EXPECT_EQ(emitted.exit, 0) << emitted.err;
    EXPECT_TRUE(fs::exists(folder / "out/tests/Aggregation/Aggregation_suite_test.cpp"));
    const auto checked = run({"conform", repository("corpus/aggregation"), "--traces", folder / "out/tests"});
    EXPECT_EQ(checked.exit, 0) << checked.out << checked.err;
    EXPECT_THAT(checked.out, HasSubstr(" 0 rejected, 0 inconclusive"));
}

TEST(TestSuites, WriteStringsAsLogsHaveThem) {
    const Folder folder;
    const testing::TemporaryFile model(
        "m.rct", R"(stm S { event a event o : string initial i state A { } transition t0 { from i to A }
        transition t { from A to A trigger a action o ! "a, (b!c\"d\\" } })");
    const auto emitted = run({"emit", "tests", model.path(), "--out", folder / "out"});
    EXPECT_EQ(emitted.exit, 0) << emitted.err;
    const auto checked = run({"conform", model.path(), "--traces", folder / "out/tests"});
    EXPECT_EQ(checked.exit, 0) << checked.out << checked.err << read_contents(folder / "out/tests/S/S.trace");
}

/// The model leaves a choice. The generated GoogleTest is linked with an implementation that takes the second choice,
/// and with one that violates the model.
TEST(TestSuites, FollowAnImplementationWhereTheModelLeavesAChoice) {
    const testing::TemporaryFile model(
        "m.rct",
        "stm M {\n event go event left event right initial i\n state A { } state B { entry left } "
        "state C { entry right }\n transition t0 { from i to A }\n"
        " transition t1 { from A to B trigger go } transition t2 { from A to C trigger go }\n"
        " transition b { from B to A trigger go } transition c { from C to A trigger go } }\n");
    const Folder folder;
    const auto emitted =
        run({"emit", "tests", model.path(), "--component", "M", "--extra-states", "1", "--out", folder / "out"});
    ASSERT_EQ(emitted.exit, 0) << emitted.err;
    EXPECT_THAT(emitted.out, HasSubstr("with choices; the tests follow what the implementation does"));
    const std::string tests = folder / "out/tests/M";
    std::ofstream(tests + "/mine.cpp") << R"(#include "implementation.hpp"
class Mine : public Implementation {
public:
    void reset() override { state = 'i'; }
    std::vector<std::string> cycle(const std::vector<std::string>& inputs) override {
        const bool first = state == 'i';
        if (first) state = 'A';
        if (inputs.empty()) return {};
        state = state == 'A' ? 'C' : 'A';
        if (state == 'A') return {};
        return {ANSWER};
    }
    char state = 'i';
};
std::unique_ptr<Implementation> make_implementation() { return std::make_unique<Mine>(); }
)";
    const auto tested = [&](const std::string& answer) {
        const std::string build =
            "cd '" + tests + "' && c++ -std=c++17 -O0 -Wall -Wextra -Werror -DANSWER='\"" + answer +
            "\"' M_adaptive_test.cpp mine.cpp -lgtest -lgtest_main -pthread -o tested && ./tested > reported 2>&1";
        return std::system(build.c_str());
    };
    EXPECT_EQ(tested("right!"), 0) << read_contents(tests + "/reported");
    EXPECT_THAT(read_contents(tests + "/reported"), HasSubstr("it does what the model allows unless it has more than"));
    EXPECT_NE(tested("up!"), 0);
    EXPECT_THAT(read_contents(tests + "/reported"), HasSubstr("it did up!; the model allows one of\n"));
    EXPECT_THAT(read_contents(tests + "/reported"), HasSubstr("\n    left!\n"));
}

/// Two machines send each other a token indefinitely, with an output each time, without time passing.
TEST(TestSuites, AreRefusedWhereACycleHasNoEnd) {
    const testing::TemporaryFile model(
        "m.rct",
        "stm Ping { event token event back event seen initial i state A { } transition t0 { from i to A action token "
        "}\n"
        " transition t1 { from A to A trigger back action seen ; token } }\n"
        "stm Pong { event token event back initial i state A { } transition t0 { from i to A }\n"
        " transition t1 { from A to A trigger token action back } }\n"
        "controller C { event seen sref p = Ping sref q = Pong connection p on token to q on token\n"
        " connection q on back to p on back connection p on seen to C on seen }\n");
    const Folder folder;
    const auto ran = run({"emit", "tests", model.path(), "--timeout", "60", "--out", folder / "out"});
    EXPECT_EQ(ran.exit, 2) << ran.out << ran.err;
    EXPECT_THAT(ran.err, HasSubstr("error[RC-A04]"));
    EXPECT_THAT(ran.err, HasSubstr("infinitely many steps without time passing"));
}

TEST(Monitors, AreEmittedAndRefused) {
    const Folder folder;
    const auto emitted = run({"emit", "monitor", repository("corpus/aggregation"), "--out", folder / "out"});
    EXPECT_EQ(emitted.exit, 0) << emitted.err;
    EXPECT_TRUE(fs::exists(folder / "out/monitor/Aggregation/Aggregation_monitor.hpp"));
    EXPECT_TRUE(fs::exists(folder / "out/monitor/Aggregation/robochart/monitor.hpp"));
    const auto large = run({"emit", "monitor", repository("corpus/swarm_taxis"), "--max-states", "20"});
    EXPECT_EQ(large.exit, 3);
    EXPECT_THAT(large.out, HasSubstr("the limit of 20 states was reached"));
    const auto endless =
        run({"emit", "tests", repository("corpus/aggregation"), "--extra-states", "8", "--out", folder / "out"});
    EXPECT_EQ(endless.exit, 2);
    EXPECT_THAT(endless.err, HasSubstr("RC-A04"));
}

TEST(Traces, AnUnreadableLogIsReportedLikeAnyInput) {
    const testing::TemporaryFile log("run.trace",
                                     "robochart-trace 1\ncomponent Aggregation\n\nrun a\nseeNobody? tock\n");
    const auto ran = run({"conform", repository("corpus/aggregation"), "--traces", log.path()});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(
        ran.err,
        HasSubstr("error[RC-L02]: aggregation::Aggregation has no input 'seeNobody'; it has seeWall, seeRobot"));
    EXPECT_THAT(ran.err, HasSubstr("run.trace:5:1"));
    EXPECT_THAT(ran.err, HasSubstr("5 | seeNobody? tock"));
    EXPECT_EQ(run({"conform", repository("corpus/aggregation"), "--traces", "no_such.trace"}).exit, 2);
    const auto other = run({"conform", repository("corpus/swarm_taxis"), "--traces", log.path()});
    EXPECT_THAT(other.err, HasSubstr("RC-L04"));
}

TEST(Traces, JsonTellsWhatWasRejected) {
    const testing::TemporaryFile log("run.trace", "robochart-trace 1\ncomponent Aggregation\nrun a\ntock\n");
    const auto ran = run({"conform", repository("corpus/aggregation"), "--traces", log.path(), "--format", "json"});
    EXPECT_EQ(ran.exit, 1) << ran.err;
    const auto report = nlohmann::json::parse(ran.out);
    EXPECT_EQ(report["schema"], "robochart-verify/traces/1");
    EXPECT_EQ(report["rejected"], 1);
    EXPECT_EQ(report["reported"][0]["line"], 4);
    EXPECT_EQ(report["reported"][0]["logged"], "the end of the cycle");
    EXPECT_THAT(report["reported"][0]["allowed"][0].get<std::string>(), HasSubstr("angularSpeed = -0.75"));
}

}  // namespace
}  // namespace robochart::app::traces_test
