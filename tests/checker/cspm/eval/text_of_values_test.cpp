// SPDX-License-Identifier: Apache-2.0
// Tests the texts of values that are data: results of `show`, and names of events. Equal values must have equal texts,
// different values must have different texts, and an expression without a value has no text.
#include "tests/checker/cspm/outcomes.hpp"

namespace robochart::cspm::test {
namespace {

TEST(TextOfValues, ShowGivesAllOfIt) {
    EXPECT_EQ(value("#show(<0..999>)"), "4890");  // 2890 digits, 999 times ", ", and < and >
    EXPECT_EQ(value("show(<0..1500>) == show(<0..1501>)"), "false");
    EXPECT_EQ(value("show({(x, <y | y <- <0..600>>) | x <- {0..1}}) == show({(x, <0..600>) | x <- {0..1}})"), "true");
    EXPECT_EQ(value("show((| 0 => <0..700>, 1 => <1> |)) == show((| 0 => <0..700>, 1 => <2> |))"), "false");
}

TEST(TextOfValues, PrintGivesAllOfIt) {
    const std::string printed = value("<1000..1999>");
    EXPECT_EQ(printed.size(), 6000U);  // 4 digits and ", " for each; the last has < and > instead of ", "
    EXPECT_EQ(printed.find("..."), std::string::npos);
}

TEST(TextOfValues, EqualSetsHaveOneText) {
    EXPECT_EQ(value("show(Set({1})) == show({{}, {1}})"), "true");
    EXPECT_EQ(value("show((Bool, {Set({1})})) == show(({false, true}, {{{}, {1}}}))"), "true");
    EXPECT_EQ(value("show(union({0..}, { -1})) == show({0..})"), "false");
}

TEST(TextOfValues, WhatHasNoneIsRefused) {
    EXPECT_EQ(value("show(<v | v <- <7, 0>, 7 / v >= 1>)"), "error: division by zero");
    EXPECT_EQ(value("show(STOP)"), "error: 'show' of a process: only data have a text");
    EXPECT_EQ(value("show(<STOP, SKIP>)"), "error: 'show' of a process: only data have a text");
    EXPECT_EQ(value("show(\\ x @ x + 1)"), "error: 'show' of a function: only data have a text");
    EXPECT_EQ(value("show(<0..>)"), "error: 'show' of an infinite sequence: <0..>");
}

// A comprehension that is evaluated element by element equals the sequence that it produces.
TEST(TextOfValues, ComprehensionsAreTheirSequences) {
    const std::string slow = "<v | v <- <7, 0>, v == 7 or 0 / v == 0>";  // the second element has no value
    EXPECT_EQ(value("head(" + slow + ")"), "7");
    EXPECT_EQ(value("show(" + slow + ")"), "error: division by zero");
    EXPECT_EQ(value("(" + slow + ", 1) == (<7>, 1)"), "error: division by zero");
    const std::string late = "let f(0) = <>\n f(n) = <n> ^ f(n - 1) within <x | x <- f(3000), x <= 2>";
    EXPECT_EQ(value("(" + late + ", 1) == (<2, 1>, 1)"), "true");
    EXPECT_EQ(value("{" + late + "} == {<2, 1>}"), "true");
}

// Two events whose texts agree in the first thousand characters are still different.
TEST(TextOfValues, EventsWithLongFieldsAreApart) {
    expect_outcomes(R"(long = <0..400>
channel c : {long ^ <1>, long ^ <2>}
P = c.(long ^ <1>) -> STOP
Q = c.(long ^ <2>) -> STOP
assert P [T= Q
assert P [T= P
assert STOP [T= P [| {| c |} |] Q
)",
                    "fhh");
}

}  // namespace
}  // namespace robochart::cspm::test
