// SPDX-License-Identifier: Apache-2.0
// Tests claims along runs outside of the model: monitors of simulations, acceptance of claims in scenarios, monitors in
// C++.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/command.hpp"
#include "tests/contents.hpp"

namespace robochart::app::testing::followed_claims_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

/// A robot that brakes three time units after each estop, and forgets an estop that comes in between.
constexpr const char* robot =
    "package p\ninterface Motors { brake() go(v : nat) }\ninterface Buttons { event estop event level : nat }\n"
    "stm Robot { const delay : nat = 3 requires Motors uses Buttons clock T var l : nat initial i\n"
    "state Moving { entry go(2) } state Waiting { } state Held { entry brake() }\n"
    "transition t0 { from i to Moving } transition t1 { from Moving to Waiting trigger estop #T }\n"
    "transition t2 { from Waiting to Held condition since(T) >= delay } transition t3 { from Held to Moving }\n"
    "transition t4 { from Moving to Moving trigger level?l condition l <= 4 } }\n";

std::string scenario(const std::string& items, const std::string& trials = "2") {
    return "scenario Brief for p::Robot { step 0.1 s physics 0.01 s duration 2 s trials " + trials +
           " seed 1 arena 100 cm by 100 cm\n"
           "robots 2 { radius 3 cm axle 5 cm wheel 12 cm/s place at (0 cm, 0 cm) heading 0 deg place at (20 cm, 0 cm) "
           "heading 0 deg }\n"
           "actuator motors is differential_drive drive motors by stop on brake drive motors by forward(2 cm/s) on go\n"
           "stimulus estop at 0.5 s stimulus level = 3 at 0.2 s measure spread is spread\n" +
           items + " }\n";
}

constexpr const char* claims =
    "import p::*\nunit 0.1 s\n"
    "claim Soon : estop leads to brake within 0.3 s\n"
    "claim Sooner : estop leads to brake within 0.2 s\n"
    "claim Small : never go(v) with v > 2\n"
    "claim Level : never level(v) with v >= 3\n"
    "claim Way : possible brake\n";

Ran simulate(const std::string& items, const std::string& text = claims, const std::vector<std::string>& options = {}) {
    const Folder folder({{"robot.rct", robot}, {"brief.scenario", scenario(items)}, {"robot.claims", text}});
    std::vector<std::string> arguments{"simulate", folder / "brief.scenario", "--no-pictures"};
    for (const std::string& option : options)
        arguments.push_back(option.ends_with(".claims") ? folder / option : option);
    return run(arguments);
}

/// Both inputs come at 0.5 s. The monitor and the code both know that the order drops one of them.
TEST(FollowedClaims, MonitorsOfModelsKnowWhatIsDropped) {
    const std::string both = "stimulus level = 3 at 0.5 s";
    const Ran simulated = simulate(both, "import p::*\nunit 0.1 s\norder Robot : estop drops level\n", {"--monitor"});
    EXPECT_EQ(simulated.exit, 0) << simulated.err;
}

TEST(FollowedClaims, StopTheTrialThatBreaksOne) {
    const Ran broken = simulate("", claims, {"robot.claims", "--monitor"});
    EXPECT_EQ(broken.exit, 1) << broken.err;
    EXPECT_THAT(broken.err, HasSubstr("error[RC-M12]"));
    EXPECT_THAT(broken.err, HasSubstr("Level is broken: level(3) comes at t=2 (0.2 s), which the claim forbids"));
    const std::string kept = "import p::*\nunit 0.1 s\nclaim Soon : estop leads to brake within 0.3 s\n";
    const Ran ran = simulate("accept each spread <= 50 cm", kept, {"robot.claims", "--monitor"});
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("claims followed: 1; robots watched: 4; an input counts when it is raised\n"));
    const Ran sooner = simulate("", "import p::*\nunit 0.1 s\nclaim S : estop leads to brake within 0.2 s\n",
                                {"robot.claims", "--monitor"});
    EXPECT_EQ(sooner.exit, 1);
    EXPECT_THAT(sooner.err, HasSubstr("S is broken: brake is owed until t=7 (0.7 s)"));
}

TEST(FollowedClaims, OfOtherComponentsAreNotFollowed) {
    const Ran ran = simulate("", "import p::*\nunit 0.1 s\nclaim W : possible brake\n", {"robot.claims", "--monitor"});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.err, HasSubstr("no claim of the file is about the controller"));
    EXPECT_THAT(ran.err, HasSubstr("one run does not show what other runs do"));
    EXPECT_EQ(run({"simulate", "a.scenario", "a.claims"}).exit, 4) << "without --monitor";
}

/// A claim that sets constants is followed if the controller has these values.
TEST(FollowedClaims, WithOtherConstantsAreNotFollowed) {
    const std::string text =
        "import p::*\nunit 0.1 s\nclaim Late : estop leads to brake within 0.5 s with constant delay of Robot set to "
        "0.5 s\n"
        "claim Same : estop leads to brake within 0.3 s with constant delay of Robot set to 3\n";
    const Ran ran = simulate("", text, {"robot.claims", "--monitor"});
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("claims followed: 1"));
    EXPECT_THAT(ran.out, HasSubstr("Late: it sets p::Robot::delay=5, and other values are used here: `--const "
                                   "p::Robot::delay=5`"));
    const Ran other = simulate("", text, {"robot.claims", "--monitor", "--const", "delay=5"});
    EXPECT_EQ(other.exit, 0) << other.err;
    EXPECT_THAT(other.out, HasSubstr("claims followed: 1"));
    EXPECT_THAT(other.out, HasSubstr("Same: it sets p::Robot::delay=3"));
    EXPECT_EQ(simulate("accept each claim Late", text).exit, 2);
}

TEST(FollowedClaims, AboutCyclesWithOtherConstantsAreNotDecided) {
    const Folder folder(
        {{"robot.rct", robot},
         {"robot.claims",
          "import p::*\nclaim Other : raised estop leads to brake within 5 units with constant delay of "
          "Robot set to 5\nclaim Same : in a cycle with estop, at most 3 any call with constant delay of "
          "Robot set to 3\n"}});
    const auto answers = [&](const std::vector<std::string>& options) {
        std::vector<std::string> arguments{"conform", folder.path(), "--format", "json"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return run(arguments);
    };
    const Ran here = answers({});
    EXPECT_THAT(here.out, HasSubstr("it sets p::Robot::delay=5, and other values are used here"));
    EXPECT_THAT(here.out, Not(HasSubstr("it sets p::Robot::delay=3")));
    const Ran there = answers({"--const", "delay=5"});
    EXPECT_THAT(there.out, HasSubstr("it sets p::Robot::delay=3"));
    EXPECT_THAT(there.out, Not(HasSubstr("it sets p::Robot::delay=5")));
}

TEST(FollowedClaims, InLogsHaveTheConstantsOfTheLog) {
    const std::string head = "robochart-trace 1\ncomponent p::Robot\n";
    const Folder folder({{"robot.rct", robot},
                         {"robot.claims",
                          "import p::*\nclaim Late : estop leads to brake within 5 units with constant delay of Robot "
                          "set to 5\n"},
                         {"here.trace", head + "run a\nestop? tock\ntock\ntock\nbrake! tock\n"},
                         {"there.trace", head + "const delay=5\nrun a\nestop? tock\ntock\ntock\ntock\ntock\nbrake!\n"},
                         {"late.trace", head + "const delay=5\nrun a\nestop? tock\ntock\ntock\ntock\ntock\ntock\n"}});
    const auto followed = [&](const std::string& name) {
        return run({"conform", folder / "robot.claims", "--traces", folder / name});
    };
    const Ran here = followed("here.trace");
    EXPECT_EQ(here.exit, 3) << here.out << here.err;
    EXPECT_THAT(here.out, HasSubstr("it sets p::Robot::delay=5"));
    const Ran there = followed("there.trace");
    EXPECT_EQ(there.exit, 0) << there.out << there.err;
    EXPECT_EQ(followed("late.trace").exit, 1);
}

TEST(FollowedClaims, ScenariosAcceptThem) {
    const Ran ran = simulate("accept each claim Soon accept each claim Small");
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("claim Soon"));
    const Ran broken = simulate("accept each claim Soon accept each claim Sooner");
    EXPECT_EQ(broken.exit, 1);
    EXPECT_THAT(broken.out, HasSubstr("Sooner: first broken in trial 1 by robot 0: brake is owed until"));
    const Ran unknown = simulate("accept each claim Sonner");
    EXPECT_EQ(unknown.exit, 2);
    EXPECT_THAT(unknown.err, HasSubstr("did you mean 'Sooner'?"));
    EXPECT_EQ(simulate("accept each claim Way").exit, 2) << "one run does not show it";
}

TEST(FollowedClaims, TheyAreMeasures) {
    const Ran ran = simulate("measure safe is kept(Sooner) accept each safe at 0.5 s >= 100 % accept each safe <= 0 %");
    EXPECT_EQ(ran.exit, 0) << ran.err;
}

TEST(FollowedClaims, HaveProbabilities) {
    const Ran kept = simulate("accept probability claim Soon >= 90 % with confidence 95 %");
    EXPECT_EQ(kept.exit, 0) << kept.err << kept.out;
    const Ran broken = simulate("accept probability claim Sooner >= 10 % with confidence 95 %");
    EXPECT_EQ(broken.exit, 1) << broken.err << broken.out;
    EXPECT_EQ(simulate("accept probability not claim Sooner >= 90 % with confidence 95 %").exit, 0);
}

TEST(FollowedClaims, BecomeMonitorsInCpp) {
    const Folder folder({{"robot.rct", robot}, {"robot.claims", claims}});
    const Ran all = run({"emit", "monitor", folder / "robot.claims", "-o", folder / "out"});
    EXPECT_EQ(all.exit, 0) << all.err;
    EXPECT_THAT(all.out, HasSubstr("Way: no monitor, because one run does not show what other runs do"));
    const std::string program =
        "#include \"Soon_monitor.hpp\"\n#include \"Sooner_monitor.hpp\"\n#include \"Level_monitor.hpp\"\n"
        "using robochart::MonitorVerdict;\n"
        "int main() {\n"
        "  Soon_monitor::Monitor soon; Sooner_monitor::Monitor sooner; Level_monitor::Monitor level;\n"
        "  soon.read(Soon_monitor::in_estop); sooner.read(Sooner_monitor::in_estop);\n"
        "  for (int i = 0; i < 3; ++i) { soon.end_of_cycle(); sooner.end_of_cycle(); }\n"
        "  if (sooner.verdict() != MonitorVerdict::violated) return 1;\n"
        "  soon.wrote(Soon_monitor::out_brake); soon.end_of_cycle();\n"
        "  if (soon.verdict() != MonitorVerdict::allowed) return 2;\n"
        "  level.read(Level_monitor::in_level, std::int64_t{1});\n"
        "  if (level.verdict() != MonitorVerdict::allowed) return 3;\n"
        "  level.read(Level_monitor::in_level, std::int64_t{3});\n"
        "  if (level.verdict() != MonitorVerdict::violated) return 4;\n"
        "  Level_monitor::Monitor outside; outside.read(Level_monitor::in_level, std::int64_t{100000});\n"
        "  return outside.verdict() == MonitorVerdict::unknown ? 0 : 5;\n"
        "}\n";
    const Folder sound(
        {{"robot.rct", robot},
         {"robot.claims",
          "import p::*\nunit 0.1 s\nclaim Soon : estop leads to brake within 0.3 s\n"
          "claim Sooner : estop leads to brake within 0.2 s\nclaim Level : never level(v) with v >= 3\n"},
         {"main.cpp", program}});
    const Ran ran = run({"emit", "monitor", sound / "robot.claims", "-o", sound / "out"});
    ASSERT_EQ(ran.exit, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("Soon: "));
    const std::string include = " -I" + (sound / "out/monitor/");
    const Ran compiled = run_shell("c++ -std=c++17 -Wall -Wextra -Werror" + include + "Soon" + include + "Sooner" +
                                   include + "Level " + (sound / "main.cpp") + " -o a.out && ./a.out");
    EXPECT_EQ(compiled.exit, 0) << compiled.err;
}

}  // namespace
}  // namespace robochart::app::testing::followed_claims_test
