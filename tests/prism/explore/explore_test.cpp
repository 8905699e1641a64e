// SPDX-License-Identifier: Apache-2.0
// Tests exploration, which implements the semantics of commands. The expected results are computed by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "prism/session/experiment.hpp"
#include "prism/session/export.hpp"
#include "tests/prism/support.hpp"

namespace robochart::prism {
namespace {

using testing::Explored;
using testing::failure_text;
using ::testing::HasSubstr;

std::string transitions(const Explored& model) {
    std::string text;
    export_transitions(*model.space, [&](std::string_view piece) { text += piece; });
    return text;
}

TEST(PrismExplore, ADtmcTakesAllCombinationsWithEqualChance) {
    // The combinations are a with the first command of R, a with the second command, and the unlabelled command. Each
    // has probability one third.
    const Explored model(
        "dtmc module L x:[0..1]; [a] x=0 -> (x'=1); endmodule\n"
        "module R y:[0..3]; [a] y=0 -> (y'=1); [a] y=0 -> (y'=2); [] y=0 -> (y'=3); endmodule");
    EXPECT_EQ(model.space->chain().states(), 4U);
    for (std::uint64_t i = 0; i < 3; ++i)
        EXPECT_EQ(model.space->chain().exact[model.space->chain().number[i]], Rational(1, 3));
}

TEST(PrismExplore, AnMdpKeepsThemApart) {
    const Explored model(
        "mdp module L x:[0..1]; [a] x=0 -> 0.5:(x'=1) + 0.5:true; [b] x=0 -> (x'=1);\n"
        "[b] x=0 -> 0.5:(x'=1) + 0.5:(x'=1); [] x=1 -> true; [] true -> true; endmodule");
    EXPECT_EQ(transitions(model), "2 6 7\n0 0 0 1\n0 1 0 0.5 a\n0 1 1 0.5 a\n0 2 1 1 b\n0 3 1 1 b\n1 0 1 1\n1 1 1 1\n");
}

TEST(PrismExplore, BranchesOfProbabilityZeroVanish) {
    const Explored model("dtmc const double p; module M x:[0..1]; [] true -> p:(x'=x+1) + 1-p:true; endmodule",
                         {{"p", {Type::real, 0, Real(std::int64_t{0})}}});
    EXPECT_EQ(transitions(model), "1 1\n0 0 1\n");  // x+1 is not even evaluated
}

TEST(PrismExplore, RightHandSidesReadTheOldState) {
    const Explored model("dtmc module M x:[0..1] init 1; y:[0..1]; [] true -> (x'=y) & (y'=x); endmodule");
    EXPECT_EQ(transitions(model), "2 2\n0 1 1\n1 0 1\n");
}

TEST(PrismExplore, InitialStatesAreThoseThatSatisfyInit) {
    const Explored model("dtmc module M x:[0..3]; b:bool; [] true -> true; endmodule init x+1<3 & (b => x=1) endinit");
    EXPECT_EQ(model.space->chain().initial.size(), 3U);  // x=0, x=1, x=1 with b
}

TEST(PrismExplore, IntsWithoutARangeHave32Bits) {
    const Explored model(
        "dtmc module M x:int init -2147483647-1; [] x<0 -> (x'=2147483647); [] x>0 -> true; endmodule");
    EXPECT_EQ(model.space->state_text(0), "x=-2147483648");
    EXPECT_EQ(model.space->state_text(1), "x=2147483647");
    EXPECT_THAT(failure_text([] { Explored("dtmc module M x:int; [] true -> (x'=x+2147483647); endmodule"); }),
                HasSubstr("PRISM-E02"));
}

TEST(PrismExplore, InfinityCompares) {
    const Explored model("dtmc module M x:[0..2] init 2; [] 1/x > 5 -> true; [] x>0 -> (x'=x-1); endmodule");
    EXPECT_EQ(transitions(model), "3 3\n0 1 1\n1 2 1\n2 2 1\n");
    EXPECT_THAT(failure_text([] { Explored("dtmc module M x:[0..2]; [] x/x > 5 -> true; endmodule"); }),
                HasSubstr("0/0 has no value"));
    EXPECT_THAT(failure_text([] { Explored("dtmc module M x:[0..2]; [] true -> 1/x:(x'=1) + 1-1/x:true; endmodule"); }),
                HasSubstr("Infinity is not a probability"));
}

/// No module synchronises with M on `a`, so the update of the command is not evaluated.
TEST(PrismExplore, CommandsThatCannotActAreNotEvaluated) {
    const Explored model(
        "dtmc module M x:[0..1]; [a] true -> (x'=x+5); [] true -> true; endmodule\n"
        "module N y:[0..1]; [a] y=1 -> true; endmodule");
    EXPECT_EQ(transitions(model), "1 1\n0 0 1\n");
}

TEST(PrismExplore, EqualChoicesOfAnMdpAreCountedEachTime) {
    const Explored model(
        "mdp module M x:[0..1]; [a] x=0 -> (x'=1); [a] x<1 -> (x'=1); [] x=1 -> true; endmodule\n"
        "module N [] true -> true; endmodule");
    EXPECT_EQ(model.space->chain().choices(), 5U);
    EXPECT_EQ(model.space->transitions(), 5U);
}

TEST(PrismExplore, ManyVariablesLieInSeveralWords) {
    std::string text = "dtmc module M\n";
    for (int i = 0; i < 40; ++i)
        text += "v" + std::to_string(i) + ":[-3..9] init " + std::to_string(i % 10 - 1) + ";\n";
    const Explored model(text + "[] v39<9 -> (v39'=v39+1) & (v0'=-3); [] v39=9 -> true; endmodule");
    EXPECT_EQ(model.space->chain().states(), 2U);
    EXPECT_THAT(model.space->state_text(1), HasSubstr("v0=-3, v1=0, v2=1"));
    EXPECT_THAT(model.space->state_text(1), HasSubstr("v38=7, v39=9"));
}

TEST(PrismExplore, ProbabilitiesMayDependOnTheState) {
    const Explored model(
        "dtmc module M x:[1..3]; [] x<3 -> 1/(x+1):(x'=x+1) + x/(x+1):true; [] x=3 -> true; endmodule");
    EXPECT_EQ(model.space->chain().exact[model.space->chain().number[2]], Rational(2, 3));
}

TEST(PrismExplore, ErrorsNameTheState) {
    EXPECT_THAT(
        failure_text([] { Explored("dtmc module M x:[0..2]; b:bool; [] true -> (x'=x+1) & (b'=true); endmodule"); }),
        HasSubstr("in the state x=2, b=true"));
    EXPECT_THAT(failure_text([] { Explored("dtmc module M x:[0..1]; [] true -> 0.5:true + 0.6:(x'=1); endmodule"); }),
                HasSubstr("sum to 1.1"));
}

TEST(PrismExplore, AlmostOneIsDividedOut) {
    const Explored model(
        "dtmc module M x:[0..2]; [] true -> 0.333333:(x'=0)+0.333333:(x'=1)+0.333333:(x'=2); endmodule");
    EXPECT_EQ(model.read.findings(), "PRISM-E12:1");
    EXPECT_EQ(model.space->chain().exact[model.space->chain().number[0]], Rational(1, 3));
}

TEST(PrismExplore, ADeadlockGetsALoopWithoutReward) {
    Explored model("mdp module M x:[0..1]; [] x=0 -> (x'=1); endmodule rewards [] true : 1; endrewards");
    EXPECT_EQ(model.read.findings(), "PRISM-E08");
    EXPECT_EQ(model.ask("Rmax=? [ C ]").low.text(), "1");
}

TEST(PrismExplore, TheMeanOfTransitionRewardsCountsCombinations) {
    // There are two combinations for a and one for b, so the reward is 2/3 * 3 + 1/3 * 9.
    Explored model(
        "dtmc module M x:[0..1]; [a] x=0 -> (x'=1); [a] x=0 -> (x'=1); [b] x=0 -> (x'=1); [] x=1 -> true; endmodule "
        "rewards [a] true : 1; [a] x=0 : 2; [b] true : 9; endrewards");
    EXPECT_EQ(model.ask("R=? [ F x=1 ]", {1e-6, true, nullptr}).low.text(), "5");
}

TEST(PrismExplore, FractionsAreAskedForWhereThereAreNone) {
    ExploreOptions options;
    options.exact = true;
    const char* root = "dtmc module M x:[0..1]; [] true -> pow(0.5,0.5):true + 1-pow(0.5,0.5):(x'=1); endmodule";
    EXPECT_EQ(failure_text([&] { Explored(root, {}, {}); }), "");
    EXPECT_THAT(failure_text([&] { Explored(root, {}, options); }), HasSubstr("error[PRISM-E13]"));
}

TEST(PrismExplore, ABoundOnStatesEndsIt) {
    ExploreOptions options;
    options.max_states = 10;
    EXPECT_THAT(failure_text([&] {
                    Explored("dtmc module M x:[0..99]; [] x<99 -> (x'=x+1); [] x=99 -> true; endmodule", {}, options);
                }),
                HasSubstr("more than 10 states"));
}

TEST(PrismExperiment, ReadsValuesAndRanges) {
    const std::vector<Constant> open{
        {Type::integer, {"N", {}}, nullptr}, {Type::real, {"p", {}}, nullptr}, {Type::boolean, {"b", {}}, nullptr}};
    const auto series = read_series("N=4:6,p=0:0.1:0.3,b=true", open);
    EXPECT_EQ(series[0].values.size(), 3U);
    ASSERT_EQ(series[1].values.size(), 4U);  // 0.3 is reached, because steps are exact
    EXPECT_EQ(series[1].values[3].text(), "0.3");
    EXPECT_EQ(combinations(series).size(), 12U);
    EXPECT_EQ(read_series("p=1/3", open)[0].values[0].text(), "1/3");
    EXPECT_EQ(read_series("p=pow(0.5,2)", open)[0].values[0].text(), "0.25");
    for (const char* wrong : {"N", "N=", "M=1", "N=0.5", "N=1:0", "N=1:0:5", "p=0:-1:5", "b=false:true", "N=1:2:3:4",
                              "N=0:1000000", "N=2147483648", "p=1/0", "=3", "N=x"})
        EXPECT_THROW((void)read_series(wrong, open), BadValue) << wrong;
}

TEST(PrismExport, WritesStatesLabelsAndGraphs) {
    const Explored model(
        "dtmc module M x:[0..1]; b:bool; [] x=0 -> (x'=1)&(b'=true); [] x=1 -> true; endmodule label \"end\" = b;");
    std::string text;
    const TextSink sink = [&](std::string_view piece) { text += piece; };
    export_states(*model.space, sink);
    EXPECT_EQ(text, "(x,b)\n0:(0,false)\n1:(1,true)\n");
    text.clear();
    export_labels(*model.space, sink);
    EXPECT_EQ(text, "0=\"init\" 1=\"deadlock\" 2=\"end\"\n0: 0\n1: 2\n");
    text.clear();
    export_graph(*model.space, sink);
    EXPECT_THAT(text, HasSubstr("0 -> 1 [label=\"1\"];"));
}

}  // namespace
}  // namespace robochart::prism
