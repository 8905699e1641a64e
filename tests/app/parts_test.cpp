// SPDX-License-Identifier: Apache-2.0
// Tests `check` with several models in one folder, assertions of other tools, and evaluation errors.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "command.hpp"

namespace robochart::app::parts_test {
namespace {

namespace fs = std::filesystem;
using testing::Folder;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::run;
using testing::TemporaryFile;

/// Returns the lines of a report that contain verdicts.
std::string verdicts(const std::string& out) {
    std::istringstream lines(out);
    std::string line, result;
    while (std::getline(lines, line))
        for (const char* word : {"holds", "FAILS", "error", "inconclusive"})
            if (line.find(std::string("  ") + word) == 0)
                result += std::string(word) + " " + line.substr(line.find_first_not_of(' ', 14), 20) + "\n";
    return result;
}

// One model counts in hundredths, the other in whole numbers. With one scale for both, the 2 of the second model would
// not be a value of its type of reals.
TEST(Project, OfSeveralModelsDecidesEachAsAlone) {
    const Folder folder({{"fine.rct",
                          "stm Fine { event o : real var x : real = 0.25 initial i state A { entry o ! x } transition "
                          "t { from i to A } }"},
                         {"fine.assertions",
                          "csp FineSpec csp-begin\nFineSpec = Fine::o.out!25 -> STOP\ncsp-end\nuntimed assertion Fine1 "
                          ": Fine equals FineSpec\n"},
                         {"whole.rct",
                          "stm Whole { event o : real var x : real = 1 initial i state A { entry o ! (x + 1) } "
                          "transition t { from i to A } }"},
                         {"whole.assertions",
                          "csp WholeSpec csp-begin\nWholeSpec = Whole::o.out!2 -> STOP\ncsp-end\nuntimed assertion "
                          "Whole1 : Whole equals WholeSpec\n"}});
    std::string alone;
    for (const char* name : {"fine.rct", "whole.rct"}) {
        const auto ran = run({"check", folder.path(name)});
        EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
        alone += verdicts(ran.out);
    }
    EXPECT_THAT(alone, HasSubstr("holds Fine1"));
    const auto together = run({"check", folder.path()});
    EXPECT_EQ(together.exit, 0) << together.out << together.err;
    EXPECT_EQ(verdicts(together.out), alone);
    EXPECT_THAT(together.out, HasSubstr("2 state machines"));
    EXPECT_THAT(together.out, HasSubstr("2 of 2 checks hold"));
    const auto one = run({"check", folder.path(), "--assertion", "Whole1"});
    EXPECT_THAT(one.out, HasSubstr("1 of 1 checks hold"));
    EXPECT_EQ(run({"emit", "csp", folder.path(), "--out", folder.path("out")}).exit, 0);
    EXPECT_TRUE(fs::exists(folder.path("out/csp-gen/fine.csp")));
    EXPECT_TRUE(fs::exists(folder.path("out/csp-gen/timed/whole_assertions.csp")));
}

TEST(Project, EachAssertionFileHasItsInstantiations) {
    const auto given = [](const std::string& name, int value) {
        const std::string number = std::to_string(value);
        return "csp Instantiations csp-begin\nnametype core_nat = {0..3}\nconst_S_k = " + number +
               "\ncsp-end\ncsp Spec csp-begin\nSpec = S::o.out!" + number + " -> STOP\ncsp-end\nuntimed assertion " +
               name + " : S equals Spec\n";
    };
    const Folder folder(
        {{"m.rct",
          "stm S { event o : nat const k : nat initial i state A { entry o ! k } transition t { from i to A } }"},
         {"one.assertions", given("One", 1)},
         {"three.assertions", given("Three", 3)}});
    const auto ran = run({"check", folder.path()});
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("2 of 2 checks hold"));
    EXPECT_THAT(ran.out, HasSubstr("1 state machine,"));
}

TEST(Project, AssertionsOfOtherToolsAreSaidNotChecked) {
    const Folder folder(
        {{"m.rct",
          "stm S { event e initial i state A { } transition t { from i to A } transition u { from A to "
          "A trigger e } }"},
         {"m.assertions",
          "untimed assertion A : S is deadlock-free\nrobocert assertion R : S conforms to Rule1\nuntimed "
          "assertion B : S is deterministic\n"}});
    const auto ran = run({"check", folder.path()});
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("m.assertions:2"));
    EXPECT_THAT(ran.out, HasSubstr("`robocert assertion` is for another tool"));
    EXPECT_THAT(ran.out, HasSubstr("2 of 3 checks hold"));
    EXPECT_EQ(run({"check", folder.path(), "--assertion", "A"}).exit, 0);
    EXPECT_EQ(run({"validate", folder.path()}).exit, 0);
}

TEST(Project, WhatCannotBeEvaluatedHasElementAndPlace) {
    const TemporaryFile interval("m.rct",
                                 "stm S { event e initial i\nstate A { entry skip ; wait([5, 1]) }\ntransition t0 { "
                                 "from i to A } transition t { from A to A trigger e } }\n");
    const auto ran = run({"check", interval.path(), "--core", "--timed"});
    EXPECT_NE(ran.exit, 0) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("m.rct:2: |~| over an empty set, in S::A"));
}

TEST(Project, IsRefusedWhereAScriptWouldBeWrong) {
    const TemporaryFile composite("m.rct",
                                  "stm S { initial i\nstate s { state inner { } }\ntransition t { from i to s } }\n");
    for (const char* verb : {"check", "conform"}) {
        const auto ran = run({verb, composite.path()});
        EXPECT_EQ(ran.exit, 2) << ran.out;
        EXPECT_THAT(ran.err, HasSubstr("RC-S21"));
        EXPECT_THAT(ran.err, HasSubstr("m.rct:2"));
    }
    const TemporaryFile block("m.rct",
                              "stm S { event card initial i state A { } transition t { from i to A } transition u { "
                              "from A to A trigger card } }\n");
    EXPECT_EQ(run({"emit", "csp", block.path(), "--out", fs::path(block.path()).parent_path().string() + "/out"}).exit,
              0);
}

// The division is in a function of the library. The error has the place of the expression in the model.
TEST(Evaluation, OfADivisionByZeroNamesPlaceAndElement) {
    const Folder folder({{"m.rct",
                          "stm S { event e : nat event o : nat var x : nat\n"
                          " initial i state A { } transition t0 { from i to A }\n"
                          " transition t { from A to A trigger e ? x\n"
                          "  condition 2 / x > 1 action o ! 1 } }\n"},
                         {"m.assertions", "untimed assertion A1 : S is deadlock-free\n"}});
    const auto ran = run({"check", folder.path()});
    EXPECT_EQ(ran.exit, 2) << ran.out;
    EXPECT_THAT(ran.out, HasSubstr("m.rct:4: division by zero, in S::t"));
}

/// Returns two packages with a controller of the same name. The second controller has an event.
Folder same_names() {
    return Folder(
        {{"a.rct",
          "package a\nstm S { initial i state A { } transition t { from i to A } }\ncontroller C { sref s = S }\n"},
         {"b.rct",
          "package b\nstm S { event e initial i state A { } transition t { from i to A } transition u { from A to A "
          "trigger e } }\n"
          "controller C { event e sref s = S connection C on e to s on e }\n"}});
}

TEST(Project, FilesOfComponentsOfOneNameDoNotReplaceEachOther) {
    const Folder folder = same_names();
    const std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>> verbs = {
        {{"emit", "cpp"}, {"cpp/a/C/S.hpp", "cpp/b/C/S.hpp"}},
        {{"emit", "cpp", "--target", "main"}, {"main/a/C/main.cpp", "main/b/C/main.cpp"}},
        {{"emit", "monitor"}, {"monitor/a/C/C_monitor.hpp", "monitor/b/C/C_monitor.hpp"}},
        {{"emit", "tests"}, {"tests/a/C/C.trace", "tests/b/C/C.trace"}},
        {{"verify"},
         {"cpp/a/C/S.hpp", "cpp/b/C/S.hpp", "csp-gen/timed/a_C_normal_form.csp", "csp-gen/timed/b_C_normal_form.csp"}}};
    for (auto [verb, files] : verbs) {
        verb.insert(verb.end(), {"--out", folder.path("out"), folder.path()});
        const auto ran = run(verb);
        // State A of the first package has no outgoing transition, so the first controller is not deadlock free.
        EXPECT_EQ(ran.exit, verb.front() == "verify" ? 1 : 0) << ran.out << ran.err;
        for (const std::string& file : files) EXPECT_TRUE(fs::exists(folder.path("out/" + file))) << file;
        fs::remove_all(folder.path("out"));
    }
    // The component's name in the output does not depend on the other selected components.
    EXPECT_EQ(run({"emit", "cpp", "--component", "b::C", "--out", folder.path("out"), folder.path()}).exit, 0);
    EXPECT_TRUE(fs::exists(folder.path("out/cpp/b/C/S.hpp")));
}

TEST(Project, NothingIsWrittenTwiceInARun) {
    const Folder folder(
        {{"m.rct", "stm S { initial i state A { } transition t { from i to A } }\ncontroller C { sref s = S }\n"},
         {"n.rct", "controller C { event e sref s = S }\n"}});
    const auto ran = run({"emit", "cpp", "--out", folder.path("out"), folder.path()});
    EXPECT_EQ(ran.exit, 2) << ran.out;
    EXPECT_THAT(ran.err, HasSubstr("error[RC-A03]"));
    EXPECT_THAT(ran.err, HasSubstr("this run has already written a file of this name"));
}

/// Returns a module `Mo` whose machine `S` counts how often it receives an event.
std::string counter(const std::string& next) {
    return "interface I { event ask event reported : nat }\n"
           "module Mo { robotic platform P { uses I } cref c = C connection P on ask to c on ask (_async)\n"
           " connection c on reported to P on reported (_async) }\n"
           "controller C { uses I sref s = S connection C on ask to s on ask connection s on reported to C on reported "
           "}\n"
           "stm S { uses I var n : nat = 0 initial i state A { } transition t0 { from i to A }\n"
           " transition t { from A to A trigger ask condition n < 1 action n = " +
           next + " ; reported ! n } }\n";
}
const std::string endless = counter("0");
const std::string once = counter("n + 1");
const std::string claims = "untimed assertion Going : Mo::c::s is deadlock-free\n";

/// Two folders whose models declare the same names.
const std::vector<std::pair<std::string, std::string>> of_one_name{{"endless/m.rct", endless},
                                                                   {"endless/m.assertions", claims},
                                                                   {"short/m.rct", once},
                                                                   {"short/m.assertions", claims}};

TEST(ProjectsOfOneName, AreJudgedAsEachAlone) {
    const Folder folder(of_one_name);
    EXPECT_EQ(run({"check", folder / "endless"}).exit, 0);
    EXPECT_EQ(run({"check", folder / "short"}).exit, 1);
    for (const std::vector<std::string>& given : {std::vector<std::string>{folder.path()},
                                                  {folder / "endless", folder / "short"},
                                                  {folder / "endless/m.rct", folder / "short/m.rct"}}) {
        std::vector<std::string> words{"check"};
        words.insert(words.end(), given.begin(), given.end());
        const auto ran = run(words);
        EXPECT_EQ(ran.exit, 1) << ran.out << ran.err;
        EXPECT_THAT(ran.out, HasSubstr("holds        endless_m: Going"));
        EXPECT_THAT(ran.out, HasSubstr("FAILS        short_m: Going"));
        EXPECT_THAT(ran.err, Not(HasSubstr("RC-"))) << "neither is wrong";
    }
    const auto valid = run({"validate", folder.path()});
    EXPECT_EQ(valid.exit, 0) << valid.err;
    EXPECT_EQ(valid.err, "");
}

TEST(ProjectsOfOneName, HaveFilesOfTheirOwn) {
    const Folder folder(of_one_name);
    for (const char* verb : {"csp", "cpp", "monitor", "tests"}) {
        const auto ran = run({"emit", verb, folder.path(), "--out", folder / "out"});
        EXPECT_EQ(ran.exit, 0) << verb << ran.out << ran.err;
    }
    for (const char* file :
         {"csp-gen/endless_m.csp", "csp-gen/timed/short_m.csp", "cpp/endless_m/Mo/Mo_core.hpp",
          "cpp/short_m/Mo/Mo_core.hpp", "monitor/endless_m/Mo/Mo_monitor.hpp", "monitor/short_m/Mo/Mo_monitor.hpp",
          "tests/endless_m/Mo/Mo.trace", "tests/short_m/Mo/Mo.trace"})
        EXPECT_TRUE(fs::exists(folder / ("out/" + std::string(file)))) << file;
    // The logs of one model are not runs of the other, so the user has to select the model.
    const std::string log = folder / "out/tests/short_m/Mo/Mo.trace";
    EXPECT_EQ(run({"conform", folder / "short", "--traces", log}).exit, 0);
    EXPECT_EQ(run({"conform", folder / "endless", "--traces", log}).exit, 1);
    const auto either = run({"conform", folder.path(), "--traces", log});
    EXPECT_EQ(either.exit, 4) << either.out << either.err;
    EXPECT_THAT(either.err, HasSubstr("endless_m and short_m both have a component"));
}

TEST(ProjectsOfOneName, ArePrintedOneAfterTheOther) {
    const Folder folder(of_one_name);
    const auto ran = run({"check", "--print", "script", folder.path()});
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_THAT(ran.out, ::testing::StartsWith("-- endless_m\n"));
    EXPECT_THAT(ran.out, HasSubstr("\n-- short_m\n"));
    const auto alone = run({"check", "--print", "script", folder / "short"});
    EXPECT_THAT(ran.out, ::testing::EndsWith(alone.out));
    EXPECT_THAT(ran.out, HasSubstr(run({"check", "--print", "script", folder / "endless"}).out));
}

TEST(ProjectsOfOneName, InOneFolderAreReportedByName) {
    const Folder folder({{"a.rct", endless}, {"b.rct", once}, {"c.assertions", claims}});
    const auto ran = run({"check", folder.path()});
    EXPECT_EQ(ran.exit, 2) << ran.out << ran.err;
    EXPECT_THAT(ran.err, HasSubstr("`Mo` is declared more than once"));
}

TEST(Project, WithErrorsDoesNotStopTheOthers) {
    const Folder folder({{"good/m.rct", endless},
                         {"good/m.assertions", claims},
                         {"wrong/w.rct", "stm W { initial i state A { } transition t { from i to Nowhere } }"}});
    const auto ran = run({"check", folder.path()});
    EXPECT_EQ(ran.exit, 2) << ran.out << ran.err;
    EXPECT_THAT(ran.err, HasSubstr("Nowhere"));
    EXPECT_THAT(ran.out, HasSubstr("1 of 1 checks hold, refused, with errors: w"));
    const auto json = nlohmann::json::parse(run({"check", "--format", "json", folder.path()}).out);
    EXPECT_EQ(json["exit"], 2);
    EXPECT_EQ(json["assertions"].at(0)["answer"], "holds");
    EXPECT_EQ(json["refused"].at(0)["model"], "w");
    EXPECT_EQ(json["refused"].at(0)["diagnostics"]["errors"], 1);
    const auto valid = run({"validate", "--format", "json", folder.path()});
    EXPECT_EQ(valid.exit, 2);
    EXPECT_EQ(nlohmann::json::parse(valid.out)["errors"], 1);
}

// The model tosses a fair coin. In RoboTool's chain, heads comes after four steps with probability 0.5.
TEST(Project, ProbabilisticClaimsAreAnsweredByRandomPaths) {
    const Folder folder(
        {{"m.rct",
          "robotic platform Table { event throw } stm Coin { event throw initial i state Ready { } state Heads { } "
          "probabilistic toss transition t0 { from i to Ready } transition t1 { from Ready to toss trigger throw } "
          "transition t2 { from toss to Heads probability 0.5 } transition t3 { from toss to Ready probability 0.5 } "
          "transition t4 { from Heads to Heads trigger throw } } "
          "controller Hand { event throw sref coin = Coin connection Hand on throw to coin on throw } "
          "module Game { rref table = Table cref hand = Hand connection table on throw to hand on throw ( _async ) }"},
         {"m.assertions",
          "label heads = Game::hand::coin is in Coin::Heads\n"
          "prob property Value : Prob=? of [Finally <=3 #heads] using sim with CI at n=1000, alpha=0.001, and "
          "pathlen=100\n"
          "prob property Holds : Prob>0.2 of [Finally <=3 #heads] using sim with SPRT at delta=0.05, alpha=0.001, and "
          "pathlen=100\n"
          "prob property Fails : Prob>0.8 of [Finally <=3 #heads] using sim with SPRT at delta=0.05, alpha=0.001, and "
          "pathlen=100\n"
          "prob property Open : Prob>0.2 of [Finally #heads] using sim with CI at n=10, alpha=0.01, and pathlen=2\n"
          "prob property Wrong : Prob>0.2 of [Finally #heads] using sim with CI at w=0, alpha=0.01, and pathlen=9\n"
          "prob generate path Run : using simulation for 2 steps\n"}});
    const auto check = [&](const char* name) {
        return run({"check", folder.path(), "--allow", "PJ3", "--allow", "PT2", "--assertion", name});
    };
    const auto value = check("Value");
    EXPECT_EQ(value.exit, 0) << value.out << value.err;
    EXPECT_THAT(value.out, HasSubstr("by random paths in RoboTool's encoding"));
    EXPECT_THAT(value.out, HasSubstr("at 99.9 % (ci, 1000 paths of 3 steps, 3 to 3); Clopper-Pearson: from 0.4"));
    EXPECT_EQ(check("Value").out.substr(value.out.find("at 99.9")), value.out.substr(value.out.find("at 99.9")))
        << "the same seed gives the same paths";
    EXPECT_EQ(check("Holds").exit, 0);
    const auto fails = check("Fails");
    EXPECT_EQ(fails.exit, 1);
    EXPECT_THAT(fails.out, Not(HasSubstr("known")));
    EXPECT_THAT(fails.out, Not(HasSubstr("states")));
    const auto open = check("Open");
    EXPECT_EQ(open.exit, 3);
    EXPECT_THAT(open.out, HasSubstr("not decided: path 1 is open after 2 steps (path=2)"));
    EXPECT_EQ(check("Wrong").exit, 2);
    const auto path = check("Run");
    EXPECT_EQ(path.exit, 0) << path.out << path.err;
    EXPECT_THAT(path.out, HasSubstr("a random path of 2 steps"));
    EXPECT_THAT(path.out, HasSubstr("0: Game::hand::coin at i\n"));
    EXPECT_THAT(path.out, HasSubstr("1: Game::hand::coin: Game::hand::coin at Ready\n"));
    EXPECT_THAT(path.out,
                HasSubstr("2: Game::hand::coin::throw.in, Game::Table::throw.out: Game::hand::coin at toss\n"));
    const auto json = nlohmann::json::parse(
        run({"check", "--format", "json", folder.path(), "--assertion", "Value", "--seed", "5"}).out);
    const auto& row = json["assertions"].at(0)["probability"]["rows"].at(0);
    EXPECT_EQ(row["answer"], "estimate");
    EXPECT_EQ(row["estimate"]["samples"], 1000);
    EXPECT_EQ(row["estimate"]["clopperPearson"].at(0), row["low"]);
}

// An undecided claim must neither count as one that holds, nor be omitted.
TEST(Project, ProbabilisticClaimsAreDecidedOrSaidNotChecked) {
    const Folder folder({{"m.rct",
                          "stm S { event e initial i state A { } transition t { from i to A } transition u { from A to "
                          "A trigger e } }"},
                         {"m.assertions",
                          "label going = S is in S::A\n"
                          "prob property P_soon: Prob>0.5 of [Finally #going]\n"
                          "prob property P_never: Prob=? of [Globally not #going]\n"
                          "untimed assertion A : S is deadlock-free\n"
                          "prob generate path P_run: using simulation for 10 steps\n"}});
    const auto ran = run({"check", folder.path()});
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("holds        P_soon Prob>0.5 of [Finally #going]"));
    EXPECT_THAT(ran.out, HasSubstr("value        P_never Prob=? of [Globally not #going]"));
    EXPECT_THAT(ran.out, HasSubstr("least 0, greatest 0"));
    EXPECT_THAT(ran.out, HasSubstr("not checked  P_run using simulation for 10 steps"));
    EXPECT_THAT(ran.out,
                HasSubstr("m.assertions:5: not checked: RoboTool's encoding is one of modules, and `S` is none"));
    EXPECT_THAT(ran.out, HasSubstr("2 of 3 checks hold, 1 value computed, 1 not checked"));
    const auto json = nlohmann::json::parse(run({"check", "--format", "json", folder.path()}).out);
    EXPECT_EQ(json["exit"], 3);
    EXPECT_EQ(json["assertions"].at(1)["answer"], "value");
    EXPECT_EQ(json["assertions"].at(1)["probability"]["encoding"], "csp");
    EXPECT_EQ(json["assertions"].at(1)["probability"]["scheduler"], "any");
    EXPECT_EQ(json["assertions"].at(1)["probability"]["rows"].at(0)["greatest"]["high"], 0.0);
    EXPECT_EQ(json["assertions"].at(2)["answer"], "not checked");
    EXPECT_EQ(run({"check", folder.path(), "--assertion", "P_soon"}).exit, 0);
    EXPECT_EQ(run({"check", folder.path(), "--assertion", "P_run"}).exit, 3);
    EXPECT_EQ(run({"check", folder.path(), "--assertion", "P_other"}).exit, 4);
    const auto chain = run({"check", folder.path(), "--encoding", "robotool", "--assertion", "P_soon"});
    EXPECT_EQ(chain.exit, 3);
    EXPECT_THAT(chain.out, HasSubstr("RoboTool's encoding is one of modules, and `S` is none"));
    EXPECT_EQ(run({"check", folder.path(), "--encoding", "robotool", "--scheduler", "urgent"}).exit, 4);
    const auto junit = run({"check", "--format", "junit", folder.path(), "--assertion", "P_never"});
    EXPECT_EQ(junit.exit, 0);
    EXPECT_THAT(junit.out, HasSubstr("failures=\"0\""));
    const auto sarif =
        nlohmann::json::parse(run({"check", "--format", "sarif", folder.path(), "--assertion", "P_never"}).out);
    EXPECT_TRUE(sarif["runs"].at(0)["results"].empty());
}

}  // namespace
}  // namespace robochart::app::parts_test
