// SPDX-License-Identifier: Apache-2.0
// Tests models of public questions and of bugs in other tools, and models for which this program once failed
// (suite/findings3). Comments derive the values. The test is skipped if the material is absent.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/contents.hpp"
#include "tests/needed.hpp"
#include "tests/prism/support.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::prism {
namespace {

namespace fs = std::filesystem;
using testing::Explored;

/// A model of the folder, and a property. Its answer is a fraction, a text or a truth value.
struct Question {
    std::string model, property, answer;
};

std::string text_of(const Result& result) {
    switch (result.kind) {
        case Result::Kind::truth:
            return result.truth ? "true" : "false";
        case Result::Kind::number:
            return result.low.text();
        case Result::Kind::range:
            return result.low.text() + ".." + result.high.text();
        case Result::Kind::states: {
            std::string text;
            for (const auto& [state, value] : result.printed) text += (text.empty() ? "" : "; ") + state;
            return text;
        }
        case Result::Kind::unknown:
            break;
    }
    return "not decided: " + result.reason;
}

/// Checks the answer with fractions, and that the enclosure contains the fraction.
void expect(const fs::path& folder, const std::vector<Question>& questions) {
    for (const Question& question : questions) {
        std::string found;
        const std::string failed = testing::failure_text([&] {
            Explored model(tests::read_contents(folder / question.model));
            const Result enclosed = model.ask(question.property);
            const bool fractions = !model.space->chain().exact.empty();
            const Result exact = fractions ? model.ask(question.property, {1e-6, true, nullptr}) : enclosed;
            found = text_of(exact);
            if (exact.kind == Result::Kind::number && exact.low.is_exact()) {
                EXPECT_LE(Rational(enclosed.low.bounds().low), exact.low.value()) << question.property;
                EXPECT_GE(Rational(enclosed.low.bounds().high), exact.low.value()) << question.property;
            }
        });
        const bool same = failed.empty() ? found == question.answer : failed.find(question.answer) != std::string::npos;
        EXPECT_TRUE(same) << question.model << ": " << question.property << ": " << found << failed << ", wanted "
                          << question.answer;
    }
}

fs::path folder(const char* name) {
    const fs::path shared = tests::shared_folder();
    return shared.empty() ? shared : shared / "suite/findings3" / name;
}

TEST(PrismQuestions, UndefinedValuesAreErrorsOnlyWhereTheyAreUsed) {
    const fs::path all = folder("prism");
    ROBOCHART_NEEDS(!all.empty() && fs::exists(all), "../shared/suite/findings3");
    expect(all, {
                    // State 0 goes to 1 and to 2 with a quarter each, and to 3 with a half. In the state x=3 both
                    // probabilities are 0.
                    {"ratio.prism", "P=? [ F x=1 ] / P=? [ F (x=1 | x=2) ]", "0.5"},
                    {"ratio.prism", "P=? [ F x=1 ] / (1 - P=? [ F x=1 ])", "1/3"},
                    {"ratio.prism", "filter(max, P=? [ F x=1 ] / (1 - P=? [ F x=1 ]))", "Infinity"},
                    {"ratio.prism", "filter(max, P=? [ F x=1 ] / P=? [ F (x=1 | x=2) ])", "0/0 has no value"},
                    {"ratio.prism", "filter(max, P=? [ F x=1 ] / P=? [ F (x=1 | x=2) ], x<3)", "1"},
                    {"ratio.prism", "filter(argmax, P=? [ F x=1 ])", "x=1"},
                    {"quot.prism", "P=? [ F x=0 ] / P=? [ F x=2 ]", "1"},
                    {"quot.prism", "1 / P=? [ F x=0 ]", "2"},
                    {"quot.prism", "log(P=? [ F x=0 ], 2)", "-1"},
                    // The path from 0 to 1 takes two steps on average, each with reward 2. State 2 never reaches 1, and
                    // state 3 may avoid it.
                    {"inf2.prism", "filter(min, R{\"a\"}=? [ F x=1 ] / R{\"b\"}=? [ F x=1 ], x=0)", "0.5"},
                    {"inf2.prism", "R{\"a\"}=? [ F x=1 ] / R{\"b\"}=? [ F x=1 ]", "Infinity/Infinity has no value"},
                    {"inf2.prism", "filter(range, R{\"a\"}=? [ F x=1 ])", "0..Infinity"},
                    // x/0 > 1000 is true and x/0 < 40 is false, so `stay` is enabled from the start.
                    {"inf.prism", "Pmin=? [ F s=3 ]", "0"},
                    {"inf.prism", "Pmax=? [ F s=3 ]", "1"},
                });
}

TEST(PrismQuestions, EveryChoiceCounts) {
    const fs::path all = folder("prism");
    ROBOCHART_NEEDS(!all.empty() && fs::exists(all), "../shared/suite/findings3");
    const Explored model(tests::read_contents(all / "uni.prism"));
    EXPECT_EQ(model.space->chain().states(), 3U);
    EXPECT_EQ(model.space->chain().choices(), 5U);
    EXPECT_EQ(model.space->transitions(), 5U);
}

TEST(PrismQuestions, NestedPathFormulasAreAnswered) {
    const fs::path all = folder("prism");
    ROBOCHART_NEEDS(!all.empty() && fs::exists(all), "../shared/suite/findings3");
    expect(all, {
                    {"ratio.prism", "P=? [ F (x=0 & F x=1) ]", "0.25"},
                    {"ratio.prism", "P=? [ G (x=0 => F x>0) ]", "1"},
                    {"ratio.prism", "P=? [ F (x=0 & X x=1) ]", "0.25"},
                    {"ratio.prism", "P=? [ (F x=1) | (F x=2) ]", "0.5"},
                });
}

TEST(PrismQuestions, PropertiesNeedNoSemicolons) {
    const fs::path all = folder("prism");
    ROBOCHART_NEEDS(!all.empty() && fs::exists(all), "../shared/suite/findings3");
    testing::Read read;
    const PropertyFile file =
        read_properties(read.sources, read.add(tests::read_contents(all / "newline-R.props")), read.diagnostics);
    EXPECT_EQ(read.findings(), "");
    EXPECT_EQ(file.properties.size(), 2U);
}

TEST(PrismQuestions, RewardsOfUnknownActionsAreErrors) {
    const fs::path all = folder("prism");
    ROBOCHART_NEEDS(!all.empty() && fs::exists(all), "../shared/suite/findings3");
    const std::string found =
        testing::failure_text([&] { Explored model(tests::read_contents(all / "reward-unknown-action.prism")); });
    EXPECT_NE(found.find("error[PRISM-T01]: action 'og' is not declared"), std::string::npos) << found;
    EXPECT_NE(found.find("did you mean 'go'?"), std::string::npos) << found;
}

TEST(PrismQuestions, WhatCameOutRightStaysRight) {
    const fs::path all = folder("right/prism");
    ROBOCHART_NEEDS(!all.empty() && fs::exists(all), "../shared/suite/findings3");
    expect(all, {
                    {"cond.prism", "Pmax=? [ F x=2 ]", "0.3"},
                    {"cond.prism", "Pmin=? [ x!=2 U x=1 ]", "0.7"},
                    {"cond.prism", "Pmax=? [ (F x=2) & (F x=1) ]", "0.3"},
                    // The self-loop of a deadlock has no reward.
                    {"dead.prism", "R{\"r\"}max=? [ C ]", "2"},
                    {"dead.prism", "R{\"r\"}max=? [ C<=5 ]", "2"},
                    {"dead.prism", "E [ F \"deadlock\" ]", "true"},
                    // Every step increases c with positive probability.
                    {"fl.prism", "P=? [ F c=2 ]", "1"},
                    {"fl.prism", "TOP", "2"},
                    {"initout.prism", "P=? [ F pc=1 ]", "error[PRISM-E03]"},
                    {"lab.prism", "P=? [ F \"odd\" ]", "error[PRISM-T14]"},  // labels are formulas over states
                    {"multi.prism", "P=? [ F s=2 ]", "1..1"},
                    {"multi.prism", "filter(count, true, \"init\")", "3"},
                    // Both reward items apply to a `go` of both modules.
                    {"multi2.prism", "Rmax=? [ F x>0 & y>0 ]", "4"},
                    {"multi2.prism", "Pmin=? [ F x=2 ]", "0"},
                    {"names.prism", "P=? [ F ma=3 ]", "1"},
                    {"names.prism", "P=? [ F<=3 ma=3 ]", "0.125"},
                    {"names.prism", "P>=0.5 [ F time=1 ]", "true"},
                    {"names.prism", "P=? [ F time=1 ]", "0.875"},
                    {"neg.prism", "R{\"gain\"}=? [ F \"home\" ]", "error[PRISM-E09]"},
                    {"ord.prism", "P=? [ F a=5 & b=5 ]", "1"},
                    // There are 36 pairs of a and b before the sum is computed. All pairs but the first also occur
                    // afterwards.
                    {"ord.prism", "filter(count, true)", "71"},
                    // Half of the paths alternate between 1 and 2.
                    {"per.prism", "R=? [ S ]", "1"},
                    {"per.prism", "S=? [ s=1 ]", "0.25"},
                    {"sum.prism", "true", "error[PRISM-E05]"},
                    {"sum2.prism", "true", "error[PRISM-E05]"},  // the third update has no probability, so it has 1
                    // A scheduler that waits forever collects no reward, but never reaches the goal.
                    {"zero.prism", "Rmin=? [ F s=1 ]", "1"},
                    {"zero.prism", "Rmax=? [ F s=1 ]", "Infinity"},
                });
    testing::Read read;
    const PropertyFile file =
        read_properties(read.sources, read.add(tests::read_contents(all / "nosemi.props")), read.diagnostics);
    EXPECT_EQ(read.findings(), "");
    EXPECT_EQ(file.properties.size(), 3U);
}

/// The robot has six units of energy. With `slow` alone it arrives unless three of six steps fail. Without energy the
/// run ends, unless the robot is at home.
TEST(PrismQuestions, ARobotWithABatteryIsDecided) {
    const fs::path all = folder("right/models");
    ROBOCHART_NEEDS(!all.empty() && fs::exists(all), "../shared/suite/findings3");
    expect(all, {
                    {"mdp.prism", "filter(count, true)", "25"},
                    {"mdp.prism", "filter(count, \"deadlock\")", "6"},
                    // With three times `fast`, the worst case is that two of three steps fail: 1 - 3 * 0.7 * 0.3^2 -
                    // 0.3^3.
                    {"mdp.prism", "Pmin=? [ F \"goal\" ]", "0.784"},
                    // If `slow` fails too often, the battery is empty on the way, so no scheduler reaches the goal with
                    // probability 1.
                    {"mdp.prism", "R{\"time\"}min=? [ F \"goal\" ]", "Infinity"},
                    {"mdp.prism", "P>=1 [ F (\"goal\" | \"deadlock\") ]", "true"},
                });
}

}  // namespace
}  // namespace robochart::prism
