// SPDX-License-Identifier: Apache-2.0
// Tests concerns and purposes, with verdicts by hand from docs/rules-language.md.
#include "claims/sleec/analysis/properties.hpp"

#include <gtest/gtest.h>

#include "claims/sleec/analysis/explain.hpp"
#include "tests/claims/sleec/support.hpp"

namespace robochart::sleec {
namespace {

using testing::Read;
using testing::with_definitions;

/// Asks about the only property of a file, and stores the answer with its example.
struct Asked {
    Answer answer = Answer::not_decided;
    std::string history, excluded;
};

Asked ask(const std::string& rules, const std::string& property, WithoutLimit without = WithoutLimit::eventually) {
    Read read(with_definitions(rules) + "concern_start p " + property + " concern_end\n");
    EXPECT_TRUE(read.checked_too().checked) << read.report();
    if (!read.checked) return {};
    AnalysisOptions options;
    options.without_limit = without;
    const CheckedProperty& concern = read.checked->concerns[0];
    const PropertyAnswer found = check_possible(*read.checked, concern, options);
    Asked result{found.possible, "", ""};
    for (const std::string& line : history_lines(found.history, concern, *read.checked)) result.history += line + "; ";
    if (found.possible == Answer::no)
        for (const std::size_t rule : excluding_rules(*read.checked, concern, options))
            result.excluded += read.checked->name(rule) + " ";
    return result;
}

TEST(SleecProperties, WithoutRulesEverythingIsPossible) {
    const Asked result = ask("", "when Go and {near} then not Stop within 5 seconds");
    EXPECT_EQ(result.answer, Answer::yes);
    EXPECT_EQ(result.history, "Go at second 0 with near; ");
    EXPECT_EQ(ask("", "exists Go").answer, Answer::yes);
    EXPECT_EQ(ask("", "exists Go and ({near} and (not {near}))").answer, Answer::no) << "the condition is never true";
}

TEST(SleecProperties, RulesExcludeWhatTheyForbid) {
    const std::string stop = "A when Go then Stop within 5 seconds\n";
    EXPECT_EQ(ask(stop, "when Go then not Stop within 5 seconds").answer, Answer::no);
    EXPECT_EQ(ask(stop, "when Go then not Stop within 4 seconds").answer, Answer::yes) << "it comes at second 5";
    EXPECT_EQ(ask(stop, "when Go then not Stop within 4 seconds").history, "Go at second 0; Stop at second 5; ");
    EXPECT_EQ(ask(stop, "when Halt then not Stop").answer, Answer::yes) << "Go need not come";
    EXPECT_EQ(ask("A when Go then not Stop within 5 seconds", "when Go then Stop within 5 seconds").answer, Answer::no);
    EXPECT_EQ(ask("A when Go then not Stop within 5 seconds", "when Go then Stop within 6 seconds").answer,
              Answer::yes);
}

/// Go requires Stop, Stop requires Alarm, and Alarm is forbidden after Go.
TEST(SleecProperties, ConsequencesOfConsequencesCount) {
    const std::string rules =
        "A when Go then Stop within 2 seconds\nB when Stop then Alarm within 2 seconds\n"
        "C when Go then not Alarm within 9 seconds\nD when Halt then Alarm within 3 seconds\n";
    const Asked go = ask(rules, "exists Go");
    EXPECT_EQ(go.answer, Answer::no);
    EXPECT_EQ(go.excluded, "A B C ");
    EXPECT_EQ(ask(rules, "exists Halt").answer, Answer::yes);
}

TEST(SleecProperties, DefeatersAndValuesCount) {
    const std::string rules = "A when Go then Stop within 2 seconds unless {near} then Help within 1 seconds\n";
    EXPECT_EQ(ask(rules, "when Go and {near} then not Stop within 9 seconds").answer, Answer::yes);
    EXPECT_EQ(ask(rules, "when Go and (not {near}) then not Stop within 9 seconds").answer, Answer::no);
}

TEST(SleecProperties, WhileIsTheSameInstant) {
    EXPECT_EQ(ask("A when Go then not Stop within 0 seconds", "exists Stop while Go").answer, Answer::yes)
        << "Stop first";
    EXPECT_EQ(ask("A when Go then not Stop within 0 seconds\nB when Stop then not Go within 0 seconds",
                  "exists Stop while Go")
                  .answer,
              Answer::no);
}

/// Duties that trigger each other forever can be fulfilled over time, but not within one instant.
TEST(SleecProperties, HistoriesAreEndless) {
    EXPECT_EQ(ask("A when Go then Stop within 2 seconds\nB when Stop then Go within 2 seconds", "exists Go").answer,
              Answer::yes);
    EXPECT_EQ(ask("A when Go then Stop within 0 seconds\nB when Stop then Go within 0 seconds", "exists Go").answer,
              Answer::no);
    EXPECT_EQ(ask("A when Go then Stop\nB when Go then not Stop", "exists Go").answer, Answer::no) << "never again";
    EXPECT_EQ(ask("A when Go then Stop\nB when Go then not Stop within 9 seconds", "exists Go").answer, Answer::yes);
    EXPECT_EQ(
        ask("A when Go then Stop\nB when Go then not Stop within 9 seconds", "exists Go", WithoutLimit::now).answer,
        Answer::no)
        << "LEGOS: at once";
}

/// An occurrence fulfils or ends a duty, and opens an equal one. At every instant some instance of the duty is open,
/// but no instance stays open forever.
TEST(SleecProperties, ADutyMayBeOpenedAnewWhereItIsFulfilled) {
    EXPECT_EQ(ask("A when Go then Go", "exists Go").answer, Answer::yes) << "Go every second";
    EXPECT_EQ(
        ask("A when Go then Stop unless Go\nB when Go then Go within 1 seconds\nC when Go then not Stop", "exists Go")
            .answer,
        Answer::yes)
        << "each Go ends what the last one asked for";
    EXPECT_EQ(
        ask("A when Go then Stop\nB when Go then Go within 1 seconds\nC when Go then not Stop", "exists Go").answer,
        Answer::no)
        << "nothing ends it";
    const std::string rules =
        "A when Go then Stop within 5 seconds otherwise Alarm\nB when Go then Go within 1 seconds\n"
        "C when Go then not Stop\n";
    EXPECT_EQ(ask(rules, "exists Go").answer, Answer::yes)
        << "Go and Alarm every second: Alarm is what the Go of five seconds ago asks for, never what the last one does";
    EXPECT_EQ(ask(rules + "D when Go then not Alarm within 1 seconds", "exists Go").answer, Answer::no)
        << "there is no second without a Go in it or before it";
}

TEST(SleecProperties, WhatIsNotDecidedIsSaid) {
    Read read(with_definitions("A when Go and (({level} + 1) > 3) then Stop") +
              "purpose_start p exists Go purpose_end\n");
    ASSERT_TRUE(read.checked_too().checked) << read.report();
    const PropertyAnswer found = check_possible(*read.checked, read.checked->purposes[0], {});
    EXPECT_EQ(found.possible, Answer::not_decided);
    EXPECT_NE(found.reason, "");
}

// ---- the instant of the trigger

/// In LEGOS, the event that triggers a property occurs at the first instant of the property.
TEST(SleecProperties, ReadAsLegosHasItTheTriggerItselfCounts) {
    for (const char* concern :
         {"when Go then not Go eventually", "when Go then not Go within 10 seconds", "when Go then not Go"}) {
        EXPECT_EQ(ask("", concern, WithoutLimit::now).answer, Answer::no) << concern;
        EXPECT_EQ(ask("", concern).answer, Answer::yes) << concern;
    }
    EXPECT_EQ(ask("", "when Go then Go within 3 seconds", WithoutLimit::now).answer, Answer::yes);
    EXPECT_EQ(ask("A when Go then not Go within 3 seconds", "exists Go", WithoutLimit::now).answer, Answer::no);
    EXPECT_EQ(ask("A when Go then not Go within 3 seconds", "exists Go").answer, Answer::yes);
}

// ---- `while` with a limit

TEST(SleecProperties, WhileWithALimitAsksForTheEventBehindTheTrigger) {
    const std::string late = "A when Go then not Stop within 5 seconds";
    EXPECT_EQ(ask(late, "exists Go while Stop within 5 seconds").answer, Answer::no);
    EXPECT_EQ(ask(late, "exists Go while Stop within 6 seconds").answer, Answer::yes);
    EXPECT_EQ(ask(late, "exists Go and {near} while Stop eventually").answer, Answer::yes);
    EXPECT_EQ(ask("A when Go then not Stop eventually", "exists Go while Stop eventually").answer, Answer::no);
}

// ---- rules that others imply together

std::string implying(const std::string& rules, std::size_t rule, WithoutLimit without = WithoutLimit::eventually) {
    Read read(with_definitions(rules));
    EXPECT_TRUE(read.checked_too().checked) << read.report();
    if (!read.checked) return "";
    AnalysisOptions options;
    options.without_limit = without;
    const Implication found = check_implied(*read.checked, rule, options);
    if (found.implied == Answer::not_decided) return found.reason;
    std::string names = found.implied == Answer::yes ? "implied by" : "";
    for (const std::size_t premise : found.by) names += " " + read.checked->name(premise);
    return names;
}

TEST(SleecProperties, ARuleMayFollowFromTwoOthers) {
    const std::string chain =
        "A when Stop then Alarm\nB when Go and {near} then Stop\nC when Go and {near} then Alarm\nD when Halt then "
        "Go\n";
    EXPECT_EQ(implying(chain, 2), "implied by A B");
    EXPECT_EQ(implying(chain, 0), "");
    EXPECT_EQ(implying(chain, 1), "");
    EXPECT_EQ(implying(chain, 3), "");
}

/// The limits add up, so Alarm occurs at second 5 at the latest, and may occur then.
TEST(SleecProperties, LimitsOfRulesThatImplyAnotherAddUp) {
    const std::string chain = "A when Go then Stop within 2 seconds\nB when Stop then Alarm within 3 seconds\n";
    EXPECT_EQ(implying(chain + "C when Go then Alarm within 5 seconds", 2), "implied by A B");
    EXPECT_EQ(implying(chain + "C when Go then Alarm within 4 seconds", 2), "");
    EXPECT_EQ(implying(chain + "C when Go and {near} then Alarm", 2), "implied by A B");
}

TEST(SleecProperties, ProhibitionsAreImpliedToo) {
    const std::string split =
        "A when Go then not Stop within 3 seconds\nB when Go then Alarm within 3 seconds\n"
        "D when Alarm then not Stop within 5 seconds\n";
    EXPECT_EQ(implying(split + "C when Go then not Stop within 4 seconds", 3), "implied by A B D");
    EXPECT_EQ(implying(split + "C when Go then not Stop within 6 seconds", 3), "")
        << "with an Alarm at second 0 the prohibition ends at second 5";
}

/// Go cannot occur without a violation of A or B. This is a conflict between A and B, and does not imply C.
TEST(SleecProperties, NothingFollowsFromAConflict) {
    EXPECT_EQ(implying("A when Go then Stop within 2 seconds\nB when Go then not Stop within 5 seconds\n"
                       "C when Go then Alarm within 9 seconds",
                       2),
              "");
}

}  // namespace
}  // namespace robochart::sleec
