// SPDX-License-Identifier: Apache-2.0
// Tests the verb `simulate`: outcomes, formats, files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "tests/contents.hpp"

namespace robochart::app::simulate_test {
namespace {

using tests::read_contents;

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::repository;
using testing::run;

/// The aggregation scenario with one replacement, in a folder that the destructor removes. The model stays in place.
class Changed {
public:
    Changed(const std::string& what, const std::string& with) : file_("changed.scenario", text(what, with)) {}
    [[nodiscard]] const std::string& path() const { return file_.path(); }

private:
    static std::string text(const std::string& what, const std::string& with) {
        std::string all = read_contents(repository("corpus/aggregation/aggregation.scenario"));
        const std::size_t at = all.find(what);
        EXPECT_NE(at, std::string::npos) << what;
        all.replace(at, what.size(), with);
        const std::size_t brace = all.find("{\n");
        return all.insert(brace + 2, "\tmodel \"" + repository("corpus/aggregation") + "\"\n");
    }
    testing::TemporaryFile file_;
};

TEST(Simulate, AggregationHoldsAndLeavesFiles) {
    const testing::Folder folder;
    const std::string out = folder / "out";
    const auto ran = run({"simulate", repository("corpus/aggregation/aggregation.scenario"), "--out", out});
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("7 of 7 bands hold"));
    EXPECT_THAT(ran.out, HasSubstr("holds    each first(c15 >= 100 %) <= 120 s"));
    for (const char* name : {"snapshots.svg", "trajectories.svg", "animation.svg", "trial-01.csv", "trial-10.csv"})
        EXPECT_TRUE(fs::exists(fs::path(out) / "simulation/Aggregation" / name)) << name;
    EXPECT_THAT(read_contents(out + "/simulation/Aggregation/trial-01.csv"),
                ::testing::StartsWith("t,id,x,y,theta,state\n0.000,0,"));
}

TEST(Simulate, JsonTellsBandsAndTrials) {
    const auto ran = run({"simulate", repository("corpus/aggregation/aggregation.scenario"), "--format", "json",
                          "--no-pictures", "--trials", "3"});
    const auto json = nlohmann::json::parse(ran.out);
    EXPECT_EQ(json.at("schema"), "robochart-verify/simulation/1");
    EXPECT_EQ(json.at("trials").size(), 3U);
    EXPECT_EQ(json.at("trials")[0].at("steps"), 1800);
    EXPECT_EQ(json.at("bands").size(), 7U);
    EXPECT_EQ(json.at("bands")[0].at("trials").size(), 3U);
    EXPECT_EQ(json.at("exit"), ran.exit);
    EXPECT_EQ(json.at("files").size(), 0U);
}

TEST(Simulate, ABandThatIsLeftIsExitOne) {
    const Changed changed("<= 120 s", "<= 1 s");
    const auto ran = run({"simulate", changed.path(), "--no-pictures", "--trials", "2"});
    EXPECT_EQ(ran.exit, 1) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("FAILS    each first(c15 >= 100 %) <= 1 s"));
    EXPECT_THAT(ran.out, HasSubstr("2 of 2 trials outside"));
}

TEST(Simulate, WrongScenariosAreExitTwoWithTheirPlace) {
    const auto expect = [](const std::string& what, const std::string& with, const std::string& code) {
        const Changed changed(what, with);
        const auto ran = run({"simulate", changed.path(), "--no-pictures"});
        EXPECT_EQ(ran.exit, 2) << with;
        EXPECT_THAT(ran.err, HasSubstr("error[" + code + "]"));
        EXPECT_THAT(ran.err, HasSubstr("changed.scenario:"));
    };
    expect("is line_of_sight", "is crystal_ball", "RC-M06");
    expect("feed seeRobot with eye.robot", "feed seeRobot with eye.distance in cm", "RC-M08");
    expect("robots 20", "robots 2000", "RC-M09");
    expect("step 0.1 s", "step 0 s", "RC-M03");
    expect("for aggregation::Aggregation", "for aggregation::Segregation", "RC-M10");
}

TEST(Simulate, WhatCannotBeWrittenIsAnErrorReportedOnce) {
    const testing::TemporaryFile file("file", "no folder");
    const std::vector<std::string> words{"simulate", repository("corpus/aggregation/aggregation.scenario"), "--out",
                                         file.path()};
    const auto text = run(words);
    EXPECT_EQ(text.exit, 2) << "though all bands hold";
    EXPECT_THAT(text.err, HasSubstr("error[RC-A03]"));
    EXPECT_THAT(text.err, HasSubstr("1 error,"));
    EXPECT_THAT(text.out, ::testing::Not(HasSubstr("rsvg-convert did not make"))) << "there is nothing to convert";
    auto more = words;
    more.insert(more.end(), {"--format", "json", "--trials", "1"});
    const auto json = run(more);
    EXPECT_EQ(json.exit, 2);
    EXPECT_THAT(json.out, HasSubstr("RC-A03"));
    EXPECT_TRUE(nlohmann::json::accept(json.out)) << json.out;
}

/// The interrupt comes during the trials or while the controller is built. In the second case the folder of the build
/// is removed.
TEST(Simulate, AnInterruptIsInconclusive) {
    const Changed changed("trials 10", "trials 100000");
    const auto ran = testing::run_and_signal({"simulate", changed.path(), "--no-pictures"}, SIGTERM);
    EXPECT_EQ(ran.exit, 3) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("interrupted"));
}

TEST(Simulate, SeedsDecide) {
    const auto value = [](const std::string& seed, const std::string& threads) {
        const auto ran = run({"simulate", repository("corpus/aggregation/aggregation.scenario"), "--format", "json",
                              "--no-pictures", "--trials", "2", "--seed", seed, "--threads", threads});
        return nlohmann::json::parse(ran.out).at("bands");
    };
    EXPECT_EQ(value("5", "1"), value("5", "2"));
    EXPECT_NE(value("5", "1"), value("50", "1"));
}

TEST(Simulate, MissingFilesAndSeveralAreRefused) {
    EXPECT_EQ(run({"simulate"}).exit, 4);
    EXPECT_EQ(run({"simulate", "/nowhere.scenario"}).exit, 2);
    const std::string scenario = repository("corpus/aggregation/aggregation.scenario");
    EXPECT_EQ(run({"simulate", scenario, scenario}).exit, 4);
}

/// Errors in assertions do not hide results that depend on the model alone. `check` reports these errors.
TEST(Simulate, AssertionsWithErrorsAreLeftOut) {
    const auto after = [](const std::string& command) {
        return testing::run_shell(
            "\"$verify\" init r --simulation > made && echo 'assertion X : r::Wandr is deadlock-fre' "
            ">> r/r.assertions && \"$verify\" " +
            command);
    };
    for (const char* command : {"simulate r/r.scenario --no-pictures --trials 1", "emit cpp r", "emit monitor r",
                                "emit tests r", "conform r --no-cache", "draw r", "step r r::Wander"}) {
        const auto ran = after(command);
        EXPECT_EQ(ran.exit, 0) << command << "\n" << ran.out << ran.err;
        EXPECT_THAT(ran.err, HasSubstr("warning[RC-A05]: the assertions of this file are ignored")) << command;
        EXPECT_THAT(ran.err, ::testing::Not(HasSubstr("error["))) << command;
    }
    for (const char* command : {"check r --no-cache", "validate r", "emit csp r", "emit cpp r --deny-warnings"})
        EXPECT_EQ(after(command).exit, 2) << command;
    const auto model = testing::run_shell(
        "\"$verify\" init r --simulation > made && echo 'stm X {' >> r/r.rct && \"$verify\" simulate r/r.scenario");
    EXPECT_EQ(model.exit, 2) << "errors in models count";
}

}  // namespace
}  // namespace robochart::app::simulate_test
