// SPDX-License-Identifier: Apache-2.0
// Tests ranges and lists of parameters, and values drawn from them.
#include "simulation/tuning/space.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace robochart::simulation {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Parameter read(const std::string& text, ParameterKind kind = ParameterKind::real) {
    std::string error;
    const auto parameter = read_parameter("x", text, kind, error);
    EXPECT_TRUE(parameter) << text << ": " << error;
    return parameter.value_or(Parameter{});
}

std::string refused(const std::string& text, ParameterKind kind = ParameterKind::real) {
    std::string error;
    EXPECT_FALSE(read_parameter("x", text, kind, error)) << text;
    return error;
}

TEST(TuningSpace, RangesHaveAHundredStepsOrMore) {
    const Parameter radius = read("0.05..0.5");
    EXPECT_EQ(radius.size(), 451U) << "0.45 in thousandths";
    EXPECT_EQ(radius.value_text(0), "0.05");
    EXPECT_EQ(radius.value_text(150), "0.2");
    EXPECT_EQ(radius.value_text(137), "0.187");
    EXPECT_EQ(radius.value_text(450), "0.5");
    EXPECT_EQ(read("0..200").size(), 201U) << "whole steps suffice";
    EXPECT_EQ(read("0.00..1").size(), 101U) << "and as many decimals as are written";
    const Parameter below = read("-1..1");
    EXPECT_EQ(below.value_text(0), "-1.0");
    EXPECT_EQ(below.value_text(5), "-0.95") << "20 steps of 0.1 would be too few";
}

TEST(TuningSpace, WholeNumbers) {
    const Parameter patience = read("5..30", ParameterKind::whole);
    EXPECT_EQ(patience.size(), 26U);
    EXPECT_EQ(patience.value_text(20), "25");
    EXPECT_EQ(read("-3..-1", ParameterKind::whole).value_text(0), "-3");
    EXPECT_THAT(refused("0.5..3", ParameterKind::whole), HasSubstr("whole numbers"));
}

TEST(TuningSpace, Lists) {
    const Parameter mode = read("Mode::A,Mode::B", ParameterKind::other);
    EXPECT_EQ(mode.size(), 2U);
    EXPECT_EQ(mode.value_text(1), "Mode::B");
    EXPECT_FALSE(mode.is_ordered());
    EXPECT_THAT(refused("1,2,1"), HasSubstr("twice"));
    EXPECT_THAT(refused("1,,2"), HasSubstr("empty"));
    EXPECT_THAT(refused("1,2,"), HasSubstr("empty"));
}

TEST(TuningSpace, WhatIsNoRange) {
    for (const char* text : {"..", "1..", "..1", "1..x", "0x1..2", "1e3..2e3", "1...2", "1..2..3", "nan..1", "1.5.2..3",
                             "1...5", "9999999999999..2", "0.1234567..1"})
        EXPECT_NE(refused(text), "") << text;
    EXPECT_THAT(refused("2..1"), HasSubstr("below"));
    EXPECT_THAT(refused("1..1"), HasSubstr("below"));
    EXPECT_THAT(refused("0..1000000"), HasSubstr("at most"));
    EXPECT_THAT(refused("-999999999999..999999999999"), HasSubstr("at most"));
    EXPECT_THAT(refused("0..1", ParameterKind::other), HasSubstr("listed"));
}

TEST(TuningSpace, WhatIsDrawnLiesWithin) {
    const std::vector<Parameter> parameters{read("0.05..0.5"), read("1..3", ParameterKind::whole), read("p,q,r")};
    Random random(1);
    Neighbourhood near = whole_space(parameters);
    std::set<std::uint64_t> first, second, third;
    for (int i = 0; i < 2000; ++i) {
        const Candidate any = draw_candidate(parameters, random);
        const Candidate close = drawn_near(parameters, {0, 2, 1}, near, random);
        for (std::size_t p = 0; p < 3; ++p) {
            EXPECT_LT(any[p], parameters[p].size());
            EXPECT_LT(close[p], parameters[p].size());
        }
        first.insert(any[0]);
        second.insert(close[1]);
        third.insert(close[2]);
    }
    EXPECT_GT(first.size(), 400U);
    EXPECT_EQ(second.size(), 3U);
    EXPECT_EQ(third.size(), 3U);
    EXPECT_THAT(constants_of(parameters, {150, 1, 2}), ElementsAre("x=0.2", "x=2", "x=r"));
}

/// After 64 new candidates of two parameters, a standard deviation of 225 steps becomes 225 / sqrt(64). Half-way
/// through, the probabilities of a list of two go from (1/2, 1/2) to (1/4, 3/4).
TEST(TuningSpace, NeighbourhoodsNarrow) {
    const std::vector<Parameter> parameters{read("0.05..0.5"), read("p,q")};
    Neighbourhood near = whole_space(parameters);
    EXPECT_EQ(near.deviations[0], 225);
    narrow_neighbourhood(near, parameters, {0, 1}, 64, 0.5);
    EXPECT_NEAR(near.deviations[0], 225.0 / 8, 1e-9);
    EXPECT_THAT(near.probabilities[1], ElementsAre(0.25, 0.75));
    widen_neighbourhood(near, parameters);
    EXPECT_NEAR(near.deviations[0], 225.0 / 4, 1e-9);
    EXPECT_THAT(near.probabilities[1], ElementsAre(0.375, 0.625));
}

}  // namespace
}  // namespace robochart::simulation
