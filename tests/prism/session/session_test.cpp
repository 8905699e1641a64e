// SPDX-License-Identifier: Apache-2.0
// Tests properties of small models, whose values are computed by hand.
#include "prism/session/session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "prism/session/state_values.hpp"
#include "tests/prism/support.hpp"

namespace robochart::prism {
namespace {

using testing::Explored;
using testing::failure_text;
using ::testing::HasSubstr;
using Kind = Result::Kind;

/// State 0 goes to 1 with probability one third, and to 2 with two thirds. Both are absorbing.
constexpr const char* fork =
    "dtmc module M s:[0..2]; [] s=0 -> 1/3:(s'=1) + 2/3:(s'=2); [] s>0 -> true; endmodule\n"
    "label \"one\" = s=1; rewards \"r\" true : 1; endrewards rewards \"e\" s=0 : 1; endrewards\n";

/// A loop that may continue, or leave to 2 or 3.
constexpr const char* loop =
    "mdp module M s:[0..3]; [] s=0 -> (s'=1); [] s=1 -> (s'=0);\n"
    "[] s=1 -> 0.5:(s'=2) + 0.5:(s'=3); [] s>=2 -> true; endmodule\n";

std::string exact(const char* model, const std::string& property) {
    const Result result = Explored(model).ask(property, {1e-6, true, nullptr});
    if (result.kind == Kind::truth) return result.truth ? "true" : "false";
    if (result.kind == Kind::unknown) return "not decided: " + result.reason;
    return result.kind == Kind::number ? result.low.text() : result.low.text() + ".." + result.high.text();
}

/// Repeats the check with enclosures, which must contain the exact answer.
void expect_agreement(const char* model, const std::string& property) {
    const Result fractions = Explored(model).ask(property, {1e-6, true, nullptr});
    const Result doubles = Explored(model).ask(property);
    ASSERT_EQ(fractions.kind, doubles.kind) << property << ": " << fractions.reason << doubles.reason;
    EXPECT_EQ(fractions.truth, doubles.truth) << property;
    if (fractions.kind == Kind::number) {
        EXPECT_LE(doubles.low.bounds().low, fractions.low.bounds().high) << property;
        EXPECT_GE(doubles.low.bounds().high, fractions.low.bounds().low) << property;
    }
}

struct Case {
    const char* model;
    const char* property;
    const char* answer;
};

TEST(PrismSession, AnswersWorkedOutByHand) {
    const Case cases[] = {
        {fork, "P=? [ F \"one\" ]", "1/3"},
        {fork, "P=? [ F \"one\" ] * 3 + 1", "2"},
        {fork, "1 - P=? [ F \"one\" ] = P=? [ F s=2 ]", "true"},
        {fork, "P=? [ G s!=1 ]", "2/3"},
        {fork, "P=? [ !(F s=1) ]", "2/3"},
        {fork, "P=? [ X X s=1 ]", "1/3"},
        {fork, "P=? [ G F s=1 ]", "1/3"},
        {fork, "P=? [ F G s=2 ]", "2/3"},
        {fork, "P=? [ F F s=1 ]", "1/3"},
        {fork, "P=? [ s=0 W s=1 ]", "1/3"},
        {fork, "P=? [ s=1 R s<2 ]", "1/3"},
        {fork, "P=? [ s=0 ]", "1"},
        {fork, "P>=1/3 [ F s=1 ]", "true"},
        {fork, "P>1/3 [ F s=1 ]", "false"},
        {fork, "P<=1/3 [ F s=1 ]", "true"},
        {fork, "P<1/3 [ F s=1 ]", "false"},
        {fork, "P>0 [ F s=1 ]", "true"},
        {fork, "P<1 [ F s=1 ]", "true"},
        {fork, "P>=1 [ G F s>0 ]", "true"},
        {fork, "P>=1 [ G s<=2 ]", "true"},
        {fork, "P<=0 [ G s=0 ]", "true"},
        {fork, "P>0 [ G s=0 ]", "false"},
        {fork, "S=? [ s=2 ]", "2/3"},
        {fork, "R{\"r\"}=? [ C<=4 ]", "4"},
        {fork, "R{\"e\"}=? [ C ]", "1"},
        {fork, "R{\"r\"}=? [ F s=1 ]", "Infinity"},
        {fork, "R{\"r\"}=? [ F s>0 ]", "1"},
        {fork, "R{\"r\"}<=1 [ F s>0 ]", "true"},
        {fork, "R{\"r\"}<1 [ F s>0 ]", "false"},
        {fork, "R{\"e\"}=? [ S ]", "0"},
        {fork, "A [ F s>0 ]", "true"},
        {fork, "A [ F s=1 ]", "false"},
        {fork, "E [ F s=1 ]", "true"},
        {fork, "E [ G s<2 ]", "true"},
        {fork, "A [ G E [ F s=1 ] ]", "false"},
        {fork, "A [ s=0 W s>0 ]", "true"},
        {fork, "E [ s=1 R s<2 ]", "true"},
        {fork, "filter(argmax, P=? [ F s=1 ]) | s=0", "true"},
        {fork, "filter(exists, s=2)", "true"},
        {fork, "filter(first, s, s>0)", "1"},
        {fork, "filter(avg, s)", "1"},
        {fork, "filter(sum, s) + 1", "4"},
        {fork, "filter(range, s)", "0..2"},
        {fork, "filter(state, s, s=2)", "2"},
        {fork, "P=? [ F s=1 {s=1} ]", "1"},
        {fork, "P=? [ F s=1 {true}{min} ]", "0"},
        {fork, "\"a\": P=? [ F s=1 ]; \"a\" * 2", "2/3"},
        {fork, "label \"two\" = s=2; P=? [ F \"two\" ]", "2/3"},
        {fork, "const int k = 1; P=? [ F<=k s=1 ]", "1/3"},
        {fork, "max(P=? [ F s=1 ], P=? [ F s=2 ])", "2/3"},
        {fork, "floor(P=? [ F s=1 ] * 3)", "1"},
        {fork, "s=0 ? P=? [ F s=1 ] : 7", "1/3"},
        {fork, "P=? [ F P>=1 [ X s=2 ] ]", "2/3"},
        {loop, "Pmax=? [ F s=2 ]", "0.5"},
        {loop, "Pmin=? [ F s=2 ]", "0"},
        {loop, "P<=0.5 [ F s=2 ]", "true"},
        {loop, "P<0.5 [ F s=2 ]", "false"},
        {loop, "P>0 [ F s=2 ]", "false"},
        {loop, "Pmax=? [ G F s=1 ]", "1"},
        {loop, "Pmin=? [ G F s=1 ]", "0"},
        {loop, "Pmax=? [ F G s=2 ]", "0.5"},
        {loop, "Pmin=? [ F G s<2 ]", "0"},
        {loop, "Pmax=? [ F G s=1 ]", "0"},
        {loop, "Pmax=? [ X X s=2 ]", "0.5"},
        {loop, "Pmin=? [ X X s=2 ]", "0"},
        {loop, "P>=1 [ F s=2 ]", "false"},
        {loop, "E [ G s<2 ]", "true"},
    };
    for (const Case& test_case : cases) {
        EXPECT_EQ(exact(test_case.model, test_case.property), test_case.answer) << test_case.property;
        expect_agreement(test_case.model, test_case.property);
    }
}

TEST(PrismSession, UndecidedPropertiesAreReported) {
    EXPECT_THAT(exact(fork, "P=? [ G (s=1 => F (s=0 & G s=2)) ]"), HasSubstr("not decided"));
    EXPECT_THAT(exact(fork, "A [ (F s=1) & (F s=2) ]"), HasSubstr("not decided"));
    EXPECT_THAT(exact(fork, "A [ F G s=1 ]"), HasSubstr("not decided"));
    EXPECT_THAT(exact(fork, "A [ F<=3 s=1 ]"), HasSubstr("not decided"));
    EXPECT_THAT(exact(fork, "R{\"r\"}=? [ s=0 U s=1 ]"), HasSubstr("not decided"));
    EXPECT_THAT(exact(fork, "filter(state, s)"), HasSubstr("needs one state"));
    EXPECT_THAT(exact(loop, "S=? [ s=1 ]"), HasSubstr("not decided"));
}

/// The value is 0.5 = 1/3 + 1/6, but enclosures of doubles cannot decide this. Models with few states are decided with
/// fractions.
TEST(PrismSession, AComparisonThatEnclosuresLeaveOpenIsDecidedByFractions) {
    const std::string model =
        "dtmc module M s:[0..3]; [] s=0 -> 1/3:(s'=1) + 1/6:(s'=2) + 1/2:(s'=3);\n"
        "[] s=1 | s=2 | s=3 -> true; endmodule\n";
    EXPECT_TRUE(Explored(model).ask("P>=0.5 [ F (s=1 | s=2) ]").truth);
    EXPECT_FALSE(Explored(model).ask("P>0.5 [ F (s=1 | s=2) ]").truth);
}

/// With many states the comparison stays undecided, and the report contains the enclosure.
TEST(PrismSession, AnOpenComparisonIsNotGuessed) {
    const std::string model =
        "dtmc module M s:[0..999]; [] s=0 -> 1/3:(s'=1) + 1/6:(s'=2) + 1/2:(s'=3);\n"
        "[] s>0 & s<995 -> 0.1:(s'=s+1) + 0.9:(s'=s+3); [] s>=995 -> true; endmodule\n";
    const Result result = Explored(model).ask("P>=0.5 [ X (s=1 | s=2) ]");
    EXPECT_EQ(result.kind, Kind::unknown);
    EXPECT_THAT(result.reason, HasSubstr("between"));
    EXPECT_TRUE(Explored(model).ask("P>=0.4 [ X (s=1 | s=2) ]").truth);
}

TEST(PrismSession, AFailingBooleanNamesAState) {
    const Result result =
        Explored("dtmc module M x:[0..2]; [] true -> true; endmodule init true endinit").ask("P>=1 [ F x=1 ]");
    EXPECT_FALSE(result.truth);
    EXPECT_EQ(result.where, "x=0");
}

TEST(PrismSession, ConstantsOfPropertiesMayStayOpenWhereNothingUsesThem) {
    EXPECT_EQ(Explored(fork).ask("const int t; P>0 [ F s=1 ]").truth, true);
    EXPECT_THAT(failure_text([] { (void)Explored(fork).ask("const int t; P=? [ F<=t s=1 ]"); }),
                HasSubstr("PRISM-E01"));
    const Values one{{"t", {Type::integer, 1, {}}}};
    EXPECT_EQ(Explored(fork).ask("const int t; P=? [ F<=t s=1 ]", {1e-6, true, nullptr}, one).low.text(), "1/3");
}

TEST(PrismSession, PrintedValues) {
    const Result result = Explored(fork).ask("filter(print, P=? [ F s=1 ])", {1e-6, true, nullptr});
    ASSERT_EQ(result.printed.size(), 2U);
    EXPECT_EQ(result.printed[1].first, "s=1");
    EXPECT_EQ(result.printed[1].second, "1");
}

TEST(PrismStateValues, RelationsOfEnclosures) {
    const Real wide(Enclosure{0.4, 0.5});
    const Real half(Rational(1, 2));
    EXPECT_EQ(apply_relation(wide, Op::less_equal, half), Truth::yes);
    EXPECT_EQ(apply_relation(wide, Op::greater, half), Truth::no);
    EXPECT_EQ(apply_relation(wide, Op::less, half), Truth::unknown);
    EXPECT_EQ(apply_relation(wide, Op::greater_equal, half), Truth::unknown);
    EXPECT_EQ(apply_relation(wide, Op::less, Real(Rational(3, 5))), Truth::yes);
    EXPECT_EQ(apply_relation(wide, Op::equal, Real(Rational(3, 5))), Truth::no);
}

TEST(PrismSession, ValuesThatNobodyUsesNeedNotExist) {
    EXPECT_EQ(exact(fork, "P=? [ F s=1 ] / P=? [ F s=2 ]"), "0.5");
    EXPECT_EQ(exact(fork, "P=? [ F s=1 ] / (1 - P=? [ F s=2 ])"), "1");  // 0/0 in the state s=2
    EXPECT_EQ(exact(fork, "filter(min, 1/s)"), "0.5");
    EXPECT_EQ(exact(fork, "filter(max, 1/s)"), "Infinity");
    EXPECT_EQ(exact(fork, "log(s, 2)"), "-Infinity");
    EXPECT_EQ(exact(fork, "filter(sum, mod(5,s), s>0)"), "1");
    EXPECT_EQ(exact(fork, "P>=1 [ F s>0 ] | mod(1,s)=0"), "true");
    EXPECT_EQ(exact(fork, "P>=1 [ F s>0 ] & mod(1,s+1)=0"), "true");
    EXPECT_EQ(exact(fork, "P>=1 [ F s>0 ] ? P=? [ F s=1 ] : mod(1,s)"), "1/3");
    for (const char* used : {"mod(1,s)", "mod(1,s)=0", "P<1 [ F s>0 ] | mod(1,s)=0", "P=? [ F mod(1,s)=0 ]",
                             "filter(count, mod(1,s)=0)", "filter(sum, mod(5,s))", "filter(argmin, mod(5,s))"})
        EXPECT_THAT(failure_text([&] { (void)exact(fork, used); }), HasSubstr("in the state s=0")) << used;
    EXPECT_EQ(Explored(fork).ask("filter(printall, mod(5,1-s) + P=? [ F s=1 ])").printed.size(), 3U);
}

TEST(PrismSession, TheStatesOfAnExtremeValueAreAnswered) {
    const auto states = [](const std::string& property, bool fractions) {
        const Result found = Explored(fork).ask(property, {1e-6, fractions, nullptr});
        EXPECT_EQ(found.kind, Kind::states) << found.reason;
        std::string text;
        for (const auto& [state, value] : found.printed) text += state + ":" + value + " ";
        return text;
    };
    for (const bool fractions : {false, true}) {
        EXPECT_EQ(states("filter(argmax, P=? [ F s=1 ])", fractions), "s=1:1 ");
        EXPECT_EQ(states("filter(argmin, P=? [ F s=1 ])", fractions), "s=2:0 ");
        EXPECT_EQ(states("filter(argmin, mod(s,2))", fractions), "s=0:0 s=2:0 ");
        EXPECT_EQ(states("filter(argmax, P=? [ F s=1 ], s!=1)", fractions).substr(0, 4), "s=0:");
    }
    EXPECT_EQ(exact(fork, "filter(count, filter(argmin, mod(s,2)))"), "2");
}

}  // namespace
}  // namespace robochart::prism
