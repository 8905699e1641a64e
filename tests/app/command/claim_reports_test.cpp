// SPDX-License-Identifier: Apache-2.0
// Tests how claims appear in JUnit's XML, in SARIF and on the page of `--html`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/command.hpp"
#include "tests/contents.hpp"

namespace robochart::app::testing::claim_reports_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

/// An obstacle holds the robot for three time units, and then it reverses. If an obstacle and a stop come in one cycle,
/// it halts and then brakes.
constexpr const char* robot =
    "package p\ninterface Motion { halt() reverse() brake() }\n"
    "stm Robot { requires Motion event obstacle event estop clock T initial i\n"
    "state Going { initial j state Free { } state Held { entry halt() } state Back { entry reverse() }\n"
    "transition t0 { from j to Free } transition t1 { from Free to Held trigger obstacle #T }\n"
    "transition t2 { from Held to Back condition since(T) >= 3 } }\n"
    "state Stopped { entry brake() } transition t3 { from i to Going }\n"
    "transition t4 { from Going to Stopped trigger estop } }\n";
constexpr const char* claims =
    "import p::*\nunit 0.1 s\n"
    "claim Soon : after obstacle until estop, reverse at least 0.4 s after halt\n"
    "claim Good : reverse at least 0.3 s after halt\n"
    "claim First : in a cycle with estop, any call but brake only after brake\n";

class ClaimReports : public ::testing::Test {
protected:
    [[nodiscard]] Ran ask(const std::string& verb, const std::vector<std::string>& options) const {
        std::vector<std::string> arguments{verb, folder_ / "m"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return run(arguments);
    }
    Folder folder_{{{"m/robot.rct", robot}, {"m/robot.claims", claims}}};
};

TEST_F(ClaimReports, InJUnit) {
    const Ran checked = ask("check", {"--format", "junit"});
    EXPECT_EQ(checked.exit, 1) << checked.err;
    EXPECT_THAT(checked.out, HasSubstr("name=\"Soon [timed] p::Robot: after obstacle until estop, reverse at least"));
    EXPECT_THAT(checked.out, HasSubstr("reverse comes at t=3 (0.3 s)"));
    const Ran conforms = ask("conform", {"--format", "junit"});
    EXPECT_EQ(conforms.exit, 1) << conforms.err;
    EXPECT_THAT(conforms.out, HasSubstr("name=\"First [the model in cycles]: in a cycle with estop"));
    const std::size_t code = conforms.out.find("name=\"First [this code]: in a cycle with estop");
    ASSERT_NE(code, std::string::npos) << conforms.out;
    EXPECT_THAT(conforms.out.substr(code), HasSubstr("<failure"));
    EXPECT_THAT(conforms.out.substr(code), HasSubstr("no brake came before"));
}

TEST_F(ClaimReports, InSarif) {
    const auto results = [](const Ran& ran) { return json::parse(ran.out).at("runs").at(0).at("results"); };
    const auto named = [](const json& all, const std::string& begin) {
        const auto found = std::ranges::find_if(all, [&](const json& result) {
            return result.at("message").at("text").get<std::string>().starts_with(begin);
        });
        return found == all.end() ? json() : *found;
    };
    const json soon = named(results(ask("check", {"--format", "sarif"})), "Soon [timed]");
    ASSERT_FALSE(soon.is_null());
    EXPECT_EQ(soon.at("kind"), "fail");
    EXPECT_EQ(soon.at("locations").at(0).at("physicalLocation").at("region").at("startLine"), 3);
    EXPECT_THAT(soon.at("codeFlows").dump(), HasSubstr("robot.rct"));
    const json all = results(ask("verify", {"--format", "sarif", "-o", folder_ / "out"}));
    for (const char* const name : {"First [the model in cycles]", "First [this code]"}) {
        const json first = named(all, name);
        ASSERT_FALSE(first.is_null()) << all.dump();
        EXPECT_EQ(first.at("kind"), "fail");
        EXPECT_EQ(first.at("locations").at(0).at("physicalLocation").at("region").at("startLine"), 5);
    }
}

/// Because of the order, the code satisfies the claim. The model in cycles still allows other orders of events. This is
/// only reported as information, because `conform` judges the code.
TEST(CycleClaimReports, FollowTheCode) {
    const Folder folder({{"m/robot.rct", robot},
                         {"m/robot.claims",
                          "import p::*\norder Robot : estop first\n"
                          "claim First : in a cycle with estop, any call but brake only after brake\n"}});
    const Ran text = run({"conform", folder / "m"});
    EXPECT_EQ(text.exit, 0) << text.out << text.err;
    EXPECT_THAT(text.out, HasSubstr("FAILS        First [the model in cycles]"));
    EXPECT_THAT(text.out, HasSubstr("holds        First [this code]"));
    const Ran junit = run({"conform", folder / "m", "--format", "junit"});
    EXPECT_EQ(junit.exit, 0);
    EXPECT_THAT(junit.out, HasSubstr("failures=\"0\" errors=\"0\" skipped=\"1\""));
    const json sarif = json::parse(run({"verify", folder / "m", "--format", "sarif", "-o", folder / "out"}).out);
    for (const json& result : sarif.at("runs").at(0).at("results")) EXPECT_NE(result.at("kind"), "fail");
}

/// A run that compares the code answers these claims, so the list of undecided claims must not contain them.
TEST(CycleClaimReports, AreAnsweredOnce) {
    const std::string claim =
        "claim First : in a cycle with estop, any call but brake only after brake\nclaim Back : reverse at least 0.3 s "
        "after halt\n";
    const Folder good(
        {{"m/robot.rct", robot}, {"m/robot.claims", "import p::*\nunit 0.1 s\norder Robot : estop first\n" + claim}});
    const Ran all = run({"verify", good / "m", "-o", good / "out"});
    EXPECT_EQ(all.exit, 0) << all.out << all.err;
    EXPECT_THAT(all.out, HasSubstr("1 of 1 claim about cycles hold"));
    EXPECT_THAT(all.out, Not(HasSubstr("inconclusive")));
    const Ran check = run({"check", good / "m"});
    EXPECT_EQ(check.exit, 3);
    EXPECT_THAT(check.out, HasSubstr("which `conform` decides"));
    const Folder bad({{"m/robot.rct", robot}, {"m/robot.claims", "import p::*\nunit 0.1 s\n" + claim}});
    const Ran quiet = run({"conform", bad / "m", "--quiet"});
    EXPECT_EQ(quiet.exit, 1);
    EXPECT_THAT(quiet.out, HasSubstr("FAILS        First [this code]"));
    EXPECT_THAT(quiet.out, HasSubstr("1 of 1 controllers conform, 0 of 1 claim about cycles hold"));
}

/// A claim about values is not decided with the few values with which the code is compared, but with the values of the
/// carriers.
TEST(CycleClaimReports, CompareValuesOfTheCarriers) {
    const Folder folder(
        {{"m/robot.rct",
          "package p\ninterface Motion { blade(spinning : boolean) go(speed : nat) }\n"
          "stm Robot { requires Motion event launch : nat event estop var v : nat initial i state Idle { }\n"
          "state Mowing { entry blade(true); go(v) } state Stopped { entry blade(false) }\n"
          "transition t0 { from i to Idle } transition t1 { from Idle to Mowing trigger launch?v }\n"
          "transition t2 { from Mowing to Stopped trigger estop } transition t3 { from Idle to Stopped trigger estop } "
          "}\n"},
         {"m/robot.claims",
          "import p::*\norder Robot : estop first\n"
          "claim Off : in a cycle with estop, never blade(true)\n"
          "claim On : in a cycle with launch, never blade(false)\n"}});
    const Ran ran = run({"conform", folder / "m"});
    EXPECT_EQ(ran.exit, 1) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("conforms     p::Robot"));
    EXPECT_THAT(ran.out, HasSubstr("holds        Off [this code]"));
    EXPECT_THAT(ran.out, HasSubstr("FAILS        Off [the model in cycles]"));
    EXPECT_THAT(ran.out, HasSubstr("FAILS        On [this code]"));
    EXPECT_THAT(ran.out, HasSubstr("for the values of the carriers only"));
}

/// The scope begins with the obstacle. Between halt and the reverse that violates the claim, time must pass.
TEST_F(ClaimReports, OnThePage) {
    const std::string page = folder_ / "page.html";
    EXPECT_EQ(ask("check", {"--html", page}).exit, 1);
    const std::string text = tests::read_contents(page);
    EXPECT_THAT(text, HasSubstr("Soon [timed] p::Robot"));
    EXPECT_THAT(text, HasSubstr("<tr class=\"step\""));
    EXPECT_THAT(text, HasSubstr("<tr class=\"step scope"));
    EXPECT_THAT(text, HasSubstr(": the scope of the claim lasts"));
    const std::size_t scope = text.find("<tr class=\"step scope");
    const std::size_t obstacle = text.find("data-text=\"input obstacle");
    ASSERT_NE(obstacle, std::string::npos);
    EXPECT_LT(scope, obstacle) << "the row of the obstacle is the first in the scope";
    EXPECT_EQ(text.find("<tr class=\"step\"", scope), std::string::npos) << "the scope lasts to the end of the run";
    const Folder other({{"m/robot.rct", robot}, {"m/robot.claims", "import p::*\nclaim N : never reverse\n"}});
    EXPECT_EQ(run({"check", other / "m", "--html", page}).exit, 1);
    EXPECT_THAT(tests::read_contents(page), Not(HasSubstr("step scope"))) << "a claim without a scope";
}

}  // namespace
}  // namespace robochart::app::testing::claim_reports_test
