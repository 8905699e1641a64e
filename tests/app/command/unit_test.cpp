// SPDX-License-Identifier: Apache-2.0
// Tests the common time unit of a project in claims, rules, logs, scenarios, generated nodes and reports
// (docs/claims.md, "One unit").
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/command.hpp"
#include "tests/contents.hpp"

namespace robochart::app::testing::unit_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

/// A robot that brakes three time units after each estop.
constexpr const char* robot =
    "package p\ninterface Motors { brake() }\ninterface Buttons { event estop }\n"
    "stm Robot { requires Motors uses Buttons clock T initial i\n"
    "state Moving { } state Waiting { } state Held { entry brake() }\n"
    "transition t0 { from i to Moving } transition t1 { from Moving to Waiting trigger estop #T }\n"
    "transition t2 { from Waiting to Held condition since(T) >= 3 } transition t3 { from Held to Moving } }\n";

std::string rules(const std::string& text) {
    return "def_start event estop event brake def_end rule_start\n" + text + "\nrule_end\n";
}

Ran judged(const std::string& rule, const std::string& claims, const std::vector<std::string>& options = {}) {
    const Folder folder({{"robot.rct", robot}, {"duty.sleec", rules(rule)}, {"robot.claims", claims}});
    std::vector<std::string> arguments{"rules", folder / "duty.sleec", folder / "robot.rct"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(arguments);
}

TEST(OneUnit, SecondsOfRulesAreSeconds) {
    EXPECT_EQ(judged("R when estop then brake within 3 seconds", "unit 1 s\n").exit, 0);
    EXPECT_EQ(judged("R when estop then brake within 2 seconds", "unit 1 s\n").exit, 1);
    EXPECT_EQ(judged("R when estop then not brake within 2 seconds", "unit 1 s\n").exit, 0);
    EXPECT_EQ(judged("R when estop then brake within 1 seconds", "unit 0.1 s\n").exit, 0);
    const Ran broken = judged("R when estop then not brake within 2 seconds", "unit 0.1 s\n");
    EXPECT_EQ(broken.exit, 1);
    EXPECT_THAT(broken.out, HasSubstr("R begins at t=0 (0.0 s) with estop: it forbids brake up to t=20 (2.0 s)"));
    EXPECT_THAT(broken.out, HasSubstr("brake comes at t=3 (0.3 s)"));
    EXPECT_THAT(broken.out, HasSubstr("1 second = 10 units\n"));
    EXPECT_EQ(judged("R when estop then brake within 1 minutes", "unit 20 s\n").exit, 0);
}

TEST(OneUnit, WithoutOneTheReportSaysWhatASecondIs) {
    const Ran ran = judged("R when estop then brake within 3 seconds", "");
    EXPECT_EQ(ran.exit, 0);
    EXPECT_THAT(ran.out, HasSubstr("1 second = 1 time unit"));
    const Ran broken = judged("R when estop then brake within 2 seconds", "", {"-q"});
    EXPECT_THAT(broken.out, HasSubstr("1 second = 1 time unit"));
    EXPECT_THAT(broken.out, HasSubstr("second 2 ends without it"));
    const json document = json::parse(judged("R when estop then brake", "", {"--format", "json"}).out);
    EXPECT_TRUE(document["unitNanoseconds"].is_null());
}

TEST(OneUnit, LimitsOfRulesAreNeverRounded) {
    const Ran ran = judged("R when estop then brake within 3 seconds", "unit 2 s\n");
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.err, HasSubstr("SLEEC-T08"));
    EXPECT_THAT(ran.err, HasSubstr("the neighbours are 2 s and 4 s; `unit 1 s` would do"));
}

TEST(OneUnit, TwoThatDifferAreAnErrorAtBoth) {
    const Folder folder({{"robot.rct", robot},
                         {"duty.sleec", rules("R when estop then brake within 3 seconds")},
                         {"a.claims", "unit 0.1 s\n"},
                         {"b.claims", "unit 0.2 s\n"},
                         {"same.claims", "unit 100 ms\n"}});
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"rules", folder / "duty.sleec", folder / "robot.rct"},
          std::vector<std::string>{"check", folder / "robot.rct"},
          std::vector<std::string>{"emit", "cpp", folder / "robot.rct", "-o", folder / "out"}}) {
        const Ran ran = run(arguments);
        EXPECT_EQ(ran.exit, 2) << arguments.front();
        EXPECT_THAT(ran.err, HasSubstr("error[CLM-T09]: one time unit is 100 ms here, and 200 ms in "));
        EXPECT_THAT(ran.err, HasSubstr("error[CLM-T09]: one time unit is 200 ms here, and 100 ms in "));
    }
}

TEST(OneUnit, AssertionsOfRulesUseIt) {
    const auto check = [&](const std::string& claims) {
        const Folder folder({{"robot.rct", robot},
                             {"duty.sleec", rules("R when estop then not brake within 2 seconds")},
                             {"robot.claims", claims},
                             {"robot.assertions", "import p::*\ntimed sleec assertion A : Robot conforms to R\n"}});
        return run({"check", folder.path(), "--assertion", "A"});
    };
    EXPECT_EQ(check("").exit, 0) << "two time units";
    const Ran ran = check("unit 0.1 s\n");
    EXPECT_EQ(ran.exit, 1) << "twenty time units";
    EXPECT_THAT(ran.out, HasSubstr("t=3 (0.3 s)"));
}

TEST(OneUnit, RunsSayIt) {
    const Folder folder({{"robot.rct", robot}, {"robot.claims", "unit 0.1 s\nclaim C : never brake\n"}});
    const Ran ran = run({"check", folder.path()});
    EXPECT_EQ(ran.exit, 1);
    EXPECT_THAT(ran.out, HasSubstr("t=3 (0.3 s) call brake"));
    EXPECT_THAT(ran.out, HasSubstr("now at t=3 (0.3 s): "));
    const json document = json::parse(run({"check", folder.path(), "--format", "json"}).out);
    EXPECT_THAT(document.dump(), HasSubstr("\"unitNanoseconds\":100000000"));
    EXPECT_THAT(run({"check", folder.path(), "--format", "sarif"}).out, HasSubstr("t=3 (0.3 s): call brake"));
    const Ran page = run({"check", folder.path(), "--html", folder / "page.html"});
    EXPECT_THAT(tests::read_contents(folder / "page.html"), HasSubstr(">3 (0.3 s)<"));
}

TEST(OneUnit, LogsAreCompared) {
    const std::string head = "robochart-trace 1\ncomponent p::Robot\nunit 0.1 s\nrun a\n";
    const std::string log = head + "estop? tock\ntock\ntock\nbrake! tock\n";
    const auto conform = [&](const std::string& claims, const std::string& input) {
        const Folder folder({{"robot.rct", robot},
                             {"robot.claims", claims},
                             {"duty.sleec", rules("R when estop then not brake within 1 seconds")},
                             {"a.trace", log}});
        return run({"conform", folder / input, "--traces", folder / "a.trace"});
    };
    for (const char* const input : {"robot.rct", "robot.claims", "duty.sleec"}) {
        const Ran ran = conform("unit 0.2 s\nclaim C : estop leads to brake within 4 units\n", input);
        EXPECT_EQ(ran.exit, 2) << input;
        EXPECT_THAT(ran.err, HasSubstr("time units of 100 ms")) << input;
        EXPECT_THAT(ran.err, HasSubstr("time units of 200 ms")) << input;
    }
    const std::string same = "unit 100 ms\nclaim C : estop leads to brake within 0.3 s\n";
    EXPECT_EQ(conform(same, "robot.rct").exit, 0);
    EXPECT_EQ(conform(same, "robot.claims").exit, 0);
    const Ran broken = conform(same, "duty.sleec");
    EXPECT_EQ(broken.exit, 1) << broken.err;
    EXPECT_THAT(broken.out, HasSubstr("brake comes at t=3 (0.3 s)"));
    EXPECT_THAT(broken.out, HasSubstr("4 time units"));
    EXPECT_EQ(conform("", "duty.sleec").exit, 0) << "a second is a time unit";
}

// ---------------------------------------------------------------- scenarios

std::string scenario(const std::string& unit) {
    return "scenario Brief for p::Robot { step 0.1 s physics 0.01 s " + unit +
           " duration 1 s trials 1 seed 1 arena 100 cm by 100 cm\n"
           "robots 1 { radius 3 cm axle 5 cm wheel 12 cm/s place at (0 cm, 0 cm) heading 0 deg }\n"
           "actuator motors is differential_drive drive motors by stop on brake\n"
           "stimulus estop at 0.1 s measure spread is spread accept each spread <= 1 cm }\n";
}

Ran simulated(const std::string& unit, const std::string& claims, const std::string& rule = "") {
    const Folder folder({{"robot.rct", robot},
                         {"brief.scenario", scenario(unit)},
                         {"robot.claims", claims},
                         {"duty.sleec", rules(rule)}});
    std::vector<std::string> arguments{"simulate", folder / "brief.scenario", "--no-pictures"};
    if (!rule.empty()) arguments.insert(arguments.end(), {folder / "duty.sleec", "--monitor"});
    return run(arguments);
}

TEST(OneUnit, ScenariosMayLeaveItOut) {
    EXPECT_EQ(simulated("", "unit 0.1 s\n").exit, 0);
    EXPECT_EQ(simulated("unit 100 ms", "unit 0.1 s\n").exit, 0);
    EXPECT_THAT(simulated("", "").err, HasSubstr("RC-M04"));
    const Ran other = simulated("unit 0.05 s", "unit 0.1 s\n");
    EXPECT_EQ(other.exit, 2);
    EXPECT_THAT(other.err, HasSubstr("error[CLM-T09]: one time unit is 50 ms here, and 100 ms in "));
    EXPECT_THAT(other.err, HasSubstr("error[CLM-T09]: one time unit is 100 ms here, and 50 ms in "));
}

TEST(OneUnit, RulesOfScenariosNeedIt) {
    const Ran none = simulated("unit 0.1 s", "", "R when estop then not brake within 1 seconds");
    EXPECT_EQ(none.exit, 2);
    EXPECT_THAT(none.err, HasSubstr("declare `unit 100 ms` in a .claims file"));
    const Ran broken = simulated("unit 0.1 s", "unit 0.1 s\n", "R when estop then not brake within 1 seconds");
    EXPECT_EQ(broken.exit, 1);
    EXPECT_THAT(broken.err, HasSubstr("it forbids brake up to t=1"));
    EXPECT_EQ(simulated("unit 0.1 s", "unit 0.1 s\n", "R when estop then brake within 1 seconds").exit, 0);
    EXPECT_EQ(simulated("unit 0.1 s", "", "R when estop then not estop within 0 seconds").exit, 0)
        << "0 seconds are 0 time units";
}

// ---------------------------------------------------------------- ROS 2

TEST(OneUnit, NodesHaveTheDeclaredCycle) {
    const auto parameters = [](const std::string& claims, const std::vector<std::string>& options) {
        const Folder folder({{"robot.rct", robot}, {"robot.claims", claims}});
        std::vector<std::string> arguments{"emit", "cpp", folder / "robot.rct", "--target",
                                           "ros2", "-o",  folder / "out"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        EXPECT_EQ(run(arguments).exit, 0);
        return tests::read_contents(folder / "out/ros2/Robot/config/robot.yaml");
    };
    EXPECT_THAT(parameters("", {}), HasSubstr("    cycle: 0.1\n"));
    EXPECT_THAT(parameters("", {}), Not(HasSubstr("cycle_scale")));
    EXPECT_THAT(parameters("unit 20 ms\n", {}), HasSubstr("    cycle: 0.02\n"));
    EXPECT_THAT(parameters("unit 20 ms\n", {}), HasSubstr("    cycle_scale: 1.0\n"));
    EXPECT_THAT(parameters("unit 20 ms\n", {"--cycle", "5"}), HasSubstr("5 time units of the model (100 ms)"));
    EXPECT_THAT(parameters("unit 20 ms\n", {"--cycle", "5"}), HasSubstr("    cycle: 0.1\n"));
    const Folder broken({{"robot.rct", robot}, {"robot.claims", "unit 1 s\nclaim of nothing"}});
    EXPECT_EQ(run({"emit", "cpp", broken / "robot.rct", "--target", "ros2", "-o", broken / "out"}).exit, 2)
        << "the file may declare an order of events";
}

}  // namespace
}  // namespace robochart::app::testing::unit_test
