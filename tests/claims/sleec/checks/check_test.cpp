// SPDX-License-Identifier: Apache-2.0
// Tests the checks of names and types in rules (docs/rules-language.md, "Two dialects").
#include <gtest/gtest.h>

#include "tests/claims/sleec/support.hpp"

namespace robochart::sleec {
namespace {

using testing::Read;
using testing::with_definitions;

std::string findings(const std::string& rules) {
    return Read(with_definitions(rules)).checked_too().findings();
}

TEST(SleecCheck, FollowsNames) {
    EXPECT_EQ(findings("R when Go then Stopp"), "SLEEC-T01:7");
    EXPECT_EQ(findings("R when near then Stop"), "SLEEC-T02:7");
    EXPECT_EQ(findings("R when Go and Stop then Halt"), "SLEEC-T02:7");
    EXPECT_EQ(findings("R when Go then Stop within MAXX seconds"), "SLEEC-T01:7");
    EXPECT_EQ(findings("R when Go then Stop within level seconds"), "SLEEC-T02:7");
    EXPECT_EQ(findings("R when Go and (Halt or near) then Stop"), "SLEEC-T02:7") << "an event stands alone";
    Read read(with_definitions("R when Go then Stopp"));
    EXPECT_EQ(read.checked_too().diagnostics.sorted_findings().front().fixes.at(0).replacement, "Stop");
}

TEST(SleecCheck, DividesEventsByTheirArguments) {
    Read read(
        with_definitions("R1 when Go(1) then Stop(red, true)\nR2 when Go(MAX) then not Stop(_, false)\n"
                         "R3 when Go(_) then Halt unless Stop(_, _)"));
    ASSERT_TRUE(read.checked_too().checked) << read.report();
    const CheckedRules& rules = *read.checked;
    std::string text;
    for (const EventCase& event : rules.events) text += event.text + " ";
    EXPECT_EQ(text,
              "Go(1) Go(5) Go(other) Stop(red, false) Stop(red, true) Stop(other, false) Stop(other, true) Halt Alarm "
              "Help ");
    EXPECT_EQ(rules.event_name(rules.rules[0].trigger), "Go(1)");
    EXPECT_EQ(rules.event_name(rules.rules[1].duty->event), "Stop(_, false)");
    EXPECT_EQ(rules.event_name(rules.rules[2].trigger), "Go(_)");
    EXPECT_EQ(rules.event_name(rules.rules[2].duty->defeaters[0].event.value()), "Stop(_, _)");
    EXPECT_EQ(rules.case_of(0, {"5"}), 1U);
    EXPECT_EQ(rules.case_of(0, {"7"}), 2U);
    EXPECT_EQ(rules.case_of(0, {}), std::nullopt);
    EXPECT_EQ(rules.case_of(1, {"blue", "true"}), 6U);
}

TEST(SleecCheck, ReadsAnEventWithoutArgumentsAsAllOfThem) {
    Read read(with_definitions("R1 when Go(1) then Stop\nR2 when Go then Halt unless Go"));
    ASSERT_TRUE(read.checked_too().checked) << read.report();
    const std::vector<CheckedRule>& rules = read.checked->rules;
    EXPECT_EQ(rules[0].trigger, EventCases(0));
    EXPECT_EQ(rules[1].trigger, EventCases({0, 1}));
    EXPECT_EQ(rules[1].duty->defeaters[0].event, EventCases({0, 1}));
}

TEST(SleecCheck, RefusesWrongArguments) {
    EXPECT_EQ(findings("R when Go(1) then Stop\nS when Go(1, _) then Stop"), "SLEEC-P09:7 SLEEC-T09:8");
    EXPECT_EQ(findings("R when Go(1) then Go(1, 2)"), "SLEEC-P09:7 SLEEC-T09:7");
    EXPECT_EQ(findings("R when Go(1) then Go(red)"), "SLEEC-P09:7 SLEEC-T09:7");
    EXPECT_EQ(findings("R when Go(near) then Stop"), "SLEEC-P09:7 SLEEC-T02:7");
    EXPECT_EQ(findings("R when Go then Stop unless Halt(1) then Stop"), "SLEEC-P09:7 SLEEC-T09:7 SLEEC-P09:7");
    std::string many;
    for (int i = 0; i < 300; ++i) many += "R" + std::to_string(i) + " when Go(" + std::to_string(i) + ") then Stop\n";
    EXPECT_NE(findings(many).find("SLEEC-T09"), std::string::npos) << "too many cases";
}

TEST(SleecCheck, StatesAreMeasuresOfTheModel) {
    Read bare(with_definitions("R when Go and Held then Stop"));
    EXPECT_EQ(bare.checked_too().diagnostics.sorted_findings().front().notes.at(0).message,
              "write `in Held` if it is a state of the model");
    Read read(with_definitions("R when Go and in A::B and not in C then Stop unless in A::B and near"));
    ASSERT_TRUE(read.checked_too().checked) << read.report();
    ASSERT_EQ(read.checked->measures.size(), 6U);
    EXPECT_EQ(read.checked->measure(4).name.text, "in A::B");
    EXPECT_FALSE(read.checked->is_state(3));
    EXPECT_TRUE(read.checked->is_state(4));
}

TEST(SleecCheck, RefusesNamesGivenTwice) {
    EXPECT_EQ(Read("def_start event A measure A : boolean def_end rule_start rule_end").checked_too().findings(),
              "SLEEC-T03:1");
    EXPECT_EQ(Read("def_start measure m : scale(a, b, a) def_end rule_start rule_end").checked_too().findings(),
              "SLEEC-T03:1");
    Read rules(with_definitions("R when Go then Stop\nR when Halt then Stop"));
    EXPECT_EQ(rules.checked_too().findings(), "SLEEC-T03:8");
    EXPECT_TRUE(rules.checked) << "of rules a warning";
}

TEST(SleecCheck, ChecksTypes) {
    for (const std::string condition :
         {"near", "not near", "level < 5", "MAX >= level", "load = mid", "mid <= load", "level = level", "1 < 2"})
        EXPECT_EQ(findings("R when Go and " + condition + " then Stop"), "") << condition;
    for (const std::string condition : {"level", "load", "5", "near = safe", "near < 5", "load < 2", "load = load",
                                        "mid = mid", "level = mid", "load = strong", "low", "not level"})
        EXPECT_TRUE(findings("R when Go and " + condition + " then Stop").starts_with("SLEEC-T0")) << condition;
}

/// LEGOS compares positions on scales, so a file in its dialect may mix scales.
TEST(SleecCheck, ReadsLiteralsByTheirPlaceInLegosOnly) {
    const std::string head =
        "def_start event Go event Stop measure a : scale(x, y) measure b : scale(u, v, w) def_end ";
    Read legos(head + "rule_start R when Go and ({a} = v) then Stop rule_end");
    EXPECT_EQ(legos.checked_too().findings(), "SLEEC-T05:1");
    EXPECT_EQ(legos.checked->rules[0].condition->parts[1].value, 1);
    EXPECT_EQ(Read(head + "rule_start R when Go and ({a} = w) then Stop rule_end").checked_too().findings(),
              "SLEEC-T04:1")
        << "there is no third value";
    EXPECT_EQ(Read(head + "rule_start R when Go and a = v then Stop rule_end").checked_too().findings(), "SLEEC-T04:1");
}

TEST(SleecCheck, WorksOutConstantsAndTimes) {
    Read read(
        "def_start event Go event Stop constant A = B constant B = 2 def_end\n"
        "rule_start R when Go then Stop within A minutes rule_end");
    ASSERT_TRUE(read.checked_too().checked) << read.report();
    EXPECT_EQ(read.checked->rules[0].duty->to, 120);
    EXPECT_EQ(Read("def_start event Go constant A = B constant B = A def_end\n"
                   "rule_start R when Go then Go within A seconds rule_end")
                  .checked_too()
                  .findings(),
              "SLEEC-T06:1");
    EXPECT_EQ(findings("R when Go then Stop within [3, 2] seconds"), "SLEEC-T07:7");
}

TEST(SleecCheck, WorksOutLimitsThatAreComputed) {
    Read read(
        with_definitions("R1 when Go then Stop within (2 * MAX - 1) minutes\n"
                         "R2 when Go then Stop within [30 seconds, 2 minutes]\n"
                         "R3 when Go then Stop within (60 - {level}) seconds"));
    ASSERT_TRUE(read.checked_too().checked) << read.report();
    EXPECT_EQ(read.checked->rules[0].duty->to, 9 * 60);
    EXPECT_EQ(read.checked->rules[1].duty->from, 30);
    EXPECT_EQ(read.checked->rules[1].duty->to, 120);
    EXPECT_FALSE(read.checked->rules[1].duty->measured);
    EXPECT_TRUE(read.checked->rules[2].duty->measured);
    EXPECT_EQ(findings("R when Go then Stop within (MAX - 9) seconds"), "SLEEC-T07:7") << "below 0";
    EXPECT_EQ(findings("R when Go then Stop within [2 minutes, 30 seconds]"), "SLEEC-T07:7");
    EXPECT_EQ(findings("R when Go then Stop within (60 - {near}) seconds"), "SLEEC-T04:7") << "a truth value";
}

/// Only LEGOS treats positions on a scale as numbers from 0.
TEST(SleecCheck, ComparesScalesWithNumbersInLegosOnly) {
    Read read(with_definitions("R when Go and ({load} > 1) then Stop"));
    ASSERT_TRUE(read.checked_too().checked) << read.report();
    EXPECT_EQ(evaluate_condition(*read.checked->rules[0].condition, {0, 0, 0, 2}), 1) << "high";
    EXPECT_EQ(evaluate_condition(*read.checked->rules[0].condition, {0, 0, 0, 1}), 0) << "mid";
    EXPECT_EQ(findings("R when Go and load > 1 then Stop"), "SLEEC-T04:7");
    EXPECT_EQ(findings("R when Go and ({load} > {near}) then Stop"), "SLEEC-T04:7");
}

/// `Stop at least 5 seconds after Go` forbids Stop at seconds 0 to 4.
TEST(SleecCheck, AtLeastForbidsTheSecondsBefore) {
    Read read(with_definitions("R Stop at least 5 seconds after Go"));
    ASSERT_TRUE(read.checked_too().checked);
    EXPECT_TRUE(read.checked->rules[0].duty->forbids);
    EXPECT_EQ(read.checked->rules[0].duty->to, 4);
}

TEST(SleecCheck, EvaluatesWithoutOverflow) {
    Read read(with_definitions("R when Go and ({level} * 1000000000 * 1000000000 * 1000000000 > 5) then Stop"));
    ASSERT_TRUE(read.checked_too().checked) << read.report();
    EXPECT_EQ(evaluate_condition(*read.checked->rules[0].condition, {0, 0, 1'000'000'000, 0}), 1);
    EXPECT_EQ(evaluate_condition(*read.checked->rules[0].condition, {0, 0, -1'000'000'000, 0}), 0);
}

}  // namespace
}  // namespace robochart::sleec
