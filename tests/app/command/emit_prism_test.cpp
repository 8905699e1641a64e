// SPDX-License-Identifier: Apache-2.0
// Tests `emit prism`: the file, ranges from preferences, bad input.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/command.hpp"
#include "tests/contents.hpp"

namespace robochart::app::testing::emit_prism_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

/// Two machines joined by a buffer. The variable `n` counts.
constexpr const char* counter =
    "robotic platform R { }\n"
    "stm S { event e var n : int initial i state A { } transition t0 { from i to A }\n"
    "  transition t1 { from A to A condition n < 3 action n = n + 1 ; e } }\n"
    "stm T { event e initial i state A { } transition t0 { from i to A } transition t1 { from A to A trigger e } }\n"
    "controller C { sref s = S sref t = T connection s on e to t on e ( _async ) }\n"
    "module M { rref r = R cref c = C }\n";

class EmitPrism : public ::testing::Test {
protected:
    Ran emit(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"emit", "prism", folder_ / "counter.rct", "-o", folder_ / "out"});
        return run(arguments);
    }
    [[nodiscard]] std::string written() const { return tests::read_contents(folder_ / "out/prism/M.prism"); }
    Folder folder_{{{"counter.rct", counter}, {"good.prefs", "INT_MIN=0\nINT_MAX=7\n"}, {"bad.prefs", "INT_MAX=x\n"}}};
};

TEST_F(EmitPrism, TheFileIsAModelOfPrism) {
    EXPECT_EQ(emit({"--range", "int=0..3", "--range", "nat=0..3"}).exit, 0);
    EXPECT_THAT(written(), HasSubstr("M_c_s_n : [0..3];"));
    EXPECT_EQ(run({"prism", folder_ / "out/prism/M.prism"}).exit, 0);
}

TEST_F(EmitPrism, PreferencesGiveTheRanges) {
    EXPECT_EQ(emit({"--prefs", folder_ / "good.prefs"}).exit, 0);
    EXPECT_THAT(written(), HasSubstr("M_c_s_n : [0..7];"));
}

/// The advice is missing if the PRISM model was not generated from RoboChart.
TEST_F(EmitPrism, AValueOutOfItsRangeSaysWhatSetsTheRange) {
    EXPECT_EQ(emit({"--range", "int=0..2", "--range", "nat=0..2"}).exit, 0);
    const Ran ran = run({"prism", folder_ / "out/prism/M.prism"});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.err, HasSubstr("PRISM-E15"));
    EXPECT_THAT(ran.err, HasSubstr("M_c_s_n=2"));
    const Ran sampled = run(
        {"prism", folder_ / "out/prism/M.prism", "--sim", "ci,samples=10", "--property", "P=? [ F<=50 M_c_s_n=3 ]"});
    EXPECT_EQ(sampled.exit, 2) << "random paths come to a state in which a step is left out";
    EXPECT_THAT(ran.err, HasSubstr("`emit prism` with --range nat=0..9"));
    EXPECT_THAT(ran.err, HasSubstr("--prefs FILE"));
    const Ran other = run({"prism", "-"}, "dtmc\nmodule M\nx : [0..2];\n[] true -> (x'=x+1);\nendmodule\n");
    EXPECT_THAT(other.err, HasSubstr("PRISM-E03"));
    EXPECT_THAT(other.err, Not(HasSubstr("emit prism")));
}

TEST_F(EmitPrism, SettingsThatAreNotFollowedAreNamed) {
    const std::vector<std::pair<std::string, std::string>> files{
        {"all.prefs", "INT_MAX=7\nMAX_SEQ_INS=3\nTYPE_OVERRIDE=a\nDBG_OPTION=true\n"}};
    const Folder more(files);
    const Ran ran = emit({"--prefs", more / "all.prefs"});
    EXPECT_EQ(ran.exit, 0);
    EXPECT_THAT(ran.err, HasSubstr("warning[RC-E08]"));
    EXPECT_THAT(ran.err, HasSubstr("MAX_SEQ_INS, TYPE_OVERRIDE are ignored"));
    EXPECT_THAT(emit({"--prefs", folder_ / "good.prefs"}).err, Not(HasSubstr("RC-E08")));
}

TEST_F(EmitPrism, BadPreferencesAreErrorsAndWriteNothing) {
    const Ran bad = emit({"--prefs", folder_ / "bad.prefs"});
    EXPECT_EQ(bad.exit, 2);
    EXPECT_THAT(bad.err, HasSubstr("error[RC-E07]"));
    EXPECT_THAT(bad.err, HasSubstr("line 1: INT_MAX: a whole number is expected"));
    EXPECT_EQ(emit({"--prefs", folder_ / "missing.prefs"}).exit, 2);
    EXPECT_EQ(emit({"--prefs", folder_ / "good.prefs", "--range", "int=0..1"}).exit, 4);
    EXPECT_EQ(written(), "");
}

TEST_F(EmitPrism, BuffersAreNotSaidToBeLeftOut) {
    EXPECT_THAT(emit({}).err, Not(HasSubstr("Cn11")));
    EXPECT_THAT(run({"emit", "csp", folder_ / "counter.rct"}).err, HasSubstr("Cn11"));
}

TEST_F(EmitPrism, JsonListsTheFile) {
    const json found = json::parse(emit({"--format", "json"}).out);
    ASSERT_EQ(found["prismFiles"].size(), 1U);
    EXPECT_EQ(found["prismFiles"][0]["bytes"], written().size());
}

}  // namespace
}  // namespace robochart::app::testing::emit_prism_test
