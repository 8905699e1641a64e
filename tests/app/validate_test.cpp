// SPDX-License-Identifier: Apache-2.0
// Tests the verb `validate`: outcomes, formats, fixes.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "command.hpp"
#include "tests/contents.hpp"

namespace robochart::app::validate_test {
namespace {

using tests::read_contents;

using testing::run;
using testing::TemporaryFile;

constexpr const char* good =
    "stm S {\n  var n : nat\n  initial i\n  state s { entry n = 1 }\n  transition t { from i to s }\n}\n";
/// The model contains these errors: `bool`, `=` for `==`, `&&`, a misspelt variable and a trailing `;`.
constexpr const char* bad =
    "stm S {\n  var counter : nat, b : bool\n  initial i\n  state s { entry countr = 1; }\n  transition t { from i to "
    "s }\n"
    "  transition u { from s to s condition counter = 1 && true }\n}\n";

TEST(Validate, SaysNothingIsWrong) {
    const TemporaryFile file("m.rct", good);
    const auto ran = run({"validate", file.path()});
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_EQ(ran.out, "valid\n");
}

TEST(Validate, ReportsInEveryFormat) {
    const TemporaryFile file("m.rct", bad);
    const auto text = run({"validate", file.path()});
    EXPECT_EQ(text.exit, 2);
    EXPECT_NE(text.err.find("error[RC-P21]"), std::string::npos) << text.err;
    EXPECT_EQ(text.err.find('\x1b'), std::string::npos);
    EXPECT_EQ(text.out, "");
    const auto json = run({"validate", "--format", "json", file.path()});
    EXPECT_EQ(json.exit, 2);
    EXPECT_EQ(nlohmann::json::parse(json.out).at("schema"), "robochart-verify/diagnostics/1");
    const auto sarif = run({"validate", "--format", "sarif", file.path()});
    EXPECT_EQ(sarif.exit, 2);
    EXPECT_EQ(nlohmann::json::parse(sarif.out).at("version"), "2.1.0");
    EXPECT_EQ(run({"validate"}).exit, 4);
    EXPECT_EQ(run({"validate", "/nowhere"}).exit, 2);
}

TEST(Validate, FixAppliesWhatIsCertainAndReportsTheRest) {
    const TemporaryFile file("m.rct", bad);
    auto ran = run({"validate", "--fix", file.path()});
    // The second round reports errors that the syntax errors hid.
    ran = run({"validate", "--fix", file.path()});
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_EQ(read_contents(file.path()),
              "stm S {\n  var counter : nat, b : boolean\n  initial i\n  state s { entry counter = 1 }\n"
              "  transition t { from i to s }\n  transition u { from s to s condition counter == 1 /\\ true }\n}\n");
    const std::string before = read_contents(file.path());
    EXPECT_EQ(run({"validate", "--fix", file.path()}).exit, 0);
    EXPECT_EQ(read_contents(file.path()), before);
}

/// The model uses notations of UML and C. Each run fixes the errors that it understands, so the next run finds more.
TEST(Validate, FixTurnsOtherNotationsIntoRoboChart) {
    const TemporaryFile file(
        "m.rct",
        "statemachine Door {\n"
        "  event open; event close;\n"
        "  clock C\n"
        "  var bool locked\n"
        "  int tries\n"
        "  initial i\n"
        "  state Closed { onentry tries = 0 do skip }\n"
        "  state Open { entry C := 0 }\n"
        "  transition t0 { from i to Closed }\n"
        "  transition t1 { from Closed to Open on open [ tries < 3 and not locked ] / tries += 1 }\n"
        "  transition t2 { Open -> Closed on close }\n"
        "  transition t3 { from Open to Closed when C > 20 }\n"
        "}\n");
    for (int pass = 0; pass < 4; ++pass) (void)run({"validate", "--fix", file.path()});
    EXPECT_EQ(read_contents(file.path()),
              "stm Door {\n"
              "  event open event close\n"
              "  clock C\n"
              "  var locked : boolean\n"
              "  var tries : int\n"
              "  initial i\n"
              "  state Closed { entry tries = 0 during skip }\n"
              "  state Open { entry #C }\n"
              "  transition t0 { from i to Closed }\n"
              "  transition t1 { from Closed to Open trigger open condition tries < 3 /\\ not locked action tries = "
              "tries + 1 }\n"
              "  transition t2 { from Open to Closed trigger close }\n"
              "  transition t3 { from Open to Closed condition since(C) > 20 }\n"
              "}\n");
    EXPECT_EQ(run({"validate", file.path()}).exit, 0);
}

/// If the fix of a claim could not be parsed, the file stays unchanged and a message says so. Claims in an assertion
/// file are moved to the end of the claims file next to it.
TEST(Validate, FixMovesClaims) {
    const testing::Folder folder(
        {{"m.rct",
          "package p\nstm S { event e initial i state A { } transition t { from i to A } transition u { from A to A "
          "trigger e } }\n"},
         {"m.claims", "import p::*\nclaim Old of S : possible e\n"},
         {"m.assertions",
          "import p::*\nunit 0.1 s\nassertion D : S is deadlock-free\nclaim A of S : at most 3 e in any 1 s\n"}});
    const testing::Ran before = run({"check", folder / "m.rct", "--deny-warnings"});
    EXPECT_NE(before.err.find("RC-P39"), std::string::npos) << before.err;
    const testing::Ran fixed = run({"validate", "--fix", folder.path()});
    EXPECT_EQ(fixed.exit, 0) << fixed.err;
    EXPECT_EQ(fixed.err.find("RC-P39"), std::string::npos) << fixed.err;
    EXPECT_EQ(read_contents(folder / "m.assertions"), "import p::*\nassertion D : S is deadlock-free\n");
    EXPECT_EQ(read_contents(folder / "m.claims"),
              "import p::*\nclaim Old of S : possible e\n\nimport p::*\n\nunit 0.1 s\nclaim A of S : at most 3 e in "
              "any 1 s\n");
    const testing::Ran after = run({"check", folder.path()});
    EXPECT_NE(after.out.find("A [timed]"), std::string::npos) << after.out;
}

TEST(Validate, ReadsRulesAndClaimsAlone) {
    const testing::Folder folder({{"good.sleec", "def_start event Go def_end rule_start R when Go then Go rule_end\n"},
                                  {"bad.sleec", "def_start event Go def_end rule_start R when Goo then Go rule_end\n"},
                                  {"far/alone/alone.claims", "claim A : never halt\n"}});
    const auto rules = run({"validate", folder / "good.sleec"});
    EXPECT_EQ(rules.exit, 0) << rules.err;
    EXPECT_NE(rules.out.find("valid"), std::string::npos) << rules.out;
    const auto both = run({"validate", folder / "good.sleec", folder / "bad.sleec", "--format", "json"});
    EXPECT_EQ(both.exit, 2);
    EXPECT_NE(both.out.find("SLEEC-T01"), std::string::npos) << both.out;
    EXPECT_NE(both.out.find("bad.sleec"), std::string::npos);
    const auto claims = run({"validate", folder / "far/alone/alone.claims"});
    EXPECT_EQ(claims.exit, 2);
    EXPECT_NE(claims.err.find("contains no RoboChart files"), std::string::npos) << claims.err;
}

TEST(Validate, FixWritesOnlyWhatReadsBetter) {
    const testing::Folder folder({{"m.rct", good}, {"c.assertions", "prob property P1 : P=? [ F S is in S::s ]\n"}});
    const auto ran = run({"validate", "--fix", folder.path()});
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_EQ(read_contents(folder / "c.assertions"), "prob property P1 : Prob=? of [ Finally S is in S::s ]\n");
}

// The blocks were written for an older generator. The fix updates names of events, processes, calls and their returns,
// and the names of a type's values. The updated blocks can be decided.
TEST(Validate, FixWritesTodaysNamesOfRoboTool) {
    const testing::Folder folder({{"m.rct",
                                   "package Yard\ninterface Motor { turn(n : nat) }\n"
                                   "stm Barrier {\n requires Motor\n event car\n event gone : nat\n"
                                   " initial i\n state Shut { entry turn(1) }\n state Up { }\n"
                                   " transition t0 { from i to Shut }\n"
                                   " transition t1 { from Shut to Up trigger car }\n"
                                   " transition t2 { from Up to Shut action gone ! 1 }\n}\n"},
                                  {"c.assertions",
                                   "csp Instantiations csp-begin\nnametype nat = {0..1}\ncsp-end\n"
                                   "import Yard::*\n"
                                   "untimed csp Cars csp-begin\n"
                                   "Cars = Barrier_turnCall!1 -> Barrier_turnRet -> "
                                   "Barrier_car.in -> Barrier_gone.out!1 -> Cars\ncsp-end\n"
                                   "untimed csp Same csp-begin\nSame = Barrier_O(0)\ncsp-end\n"
                                   "untimed assertion A1 : Barrier refines Cars\n"
                                   "untimed assertion A2 : Barrier refines Same\n"}});
    const auto before = run({"check", folder.path()});
    EXPECT_EQ(before.exit, 2);
    const auto fixed = run({"validate", "--fix", folder.path()});
    EXPECT_EQ(fixed.exit, 0) << fixed.out << fixed.err;
    const std::string text = read_contents(folder / "c.assertions");
    EXPECT_NE(text.find("nametype core_nat = {0..1}"), std::string::npos) << text;
    EXPECT_NE(text.find("Cars = Yard::Barrier::turnCall!1 -> Yard::Barrier::car.in -> Yard::Barrier::gone.out!1 -> "
                        "Cars"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("Same = Yard::Barrier::O__(0)"), std::string::npos) << text;
    const auto after = run({"check", folder.path()});
    EXPECT_EQ(after.exit, 0) << after.out << after.err;
    EXPECT_NE(after.out.find("2 of 2 checks hold"), std::string::npos) << after.out;
}

TEST(Validate, LooksIntoCspBlocks) {
    const testing::Folder folder({{"m.rct", good},
                                  {"c.assertions",
                                   "untimed csp P csp-begin\nP = e -> P\ncsp-end\n"
                                   "untimed assertion A : S refines P in the traces model\n"}});
    const auto ran = run({"validate", folder.path()});
    EXPECT_EQ(ran.exit, 2) << ran.err;
    EXPECT_NE(ran.err.find("error[CSPM-T01]"), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find("c.assertions:2:5"), std::string::npos) << ran.err;
}

/// An error caused by the model's text is bad input, with its place. An error caused by an option is wrong usage.
TEST(Refused, ByTheModelOrByAnOption) {
    const TemporaryFile file("m.rct",
                             "stm S {\n  var n : nat\n  initial i\n  state s { entry n = 99999999999999999999 }\n"
                             "  transition t { from i to s }\n}\n");
    const auto by_model = run({"check", "--core", file.path()});
    EXPECT_EQ(by_model.exit, 2) << by_model.err;
    EXPECT_NE(by_model.err.find("m.rct:4:"), std::string::npos) << by_model.err;
    const TemporaryFile small("m.rct", good);
    const auto by_option = run({"check", "--core", "--range", "nat=0..100000000000", small.path()});
    EXPECT_EQ(by_option.exit, 4) << by_option.err;
    const TemporaryFile types("t.rct", "enumeration Colour { red blue }\n");
    const auto lacking = run({"emit", "cpp", types.path()});
    EXPECT_EQ(lacking.exit, 2) << lacking.err;
    EXPECT_NE(lacking.err.find("t.rct:1:1"), std::string::npos) << lacking.err;
}

}  // namespace
}  // namespace robochart::app::validate_test
