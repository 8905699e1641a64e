// SPDX-License-Identifier: Apache-2.0
// Tests conflicts and redundancy by the default semantics. For the seven faults of SLEEC-TK (shared/reference, sleec.md
// 2), the correct verdicts are expected. The other verdicts follow from docs/rules-language.md by hand.
#include <gtest/gtest.h>

#include "claims/sleec/analysis/conflicts.hpp"
#include "claims/sleec/analysis/suggest.hpp"
#include "tests/claims/sleec/support.hpp"

namespace robochart::sleec {
namespace {

using testing::Read;
using testing::with_definitions;

CheckedRules rules_of(const std::string& rules) {
    Read read(with_definitions(rules));
    if (!read.checked_too().checked) throw std::runtime_error(read.report());
    return *read.checked;
}

/// Returns the conflicts, with rules by name: "R1-R2 R3".
std::string conflicts(const std::string& rules, WithoutLimit without = WithoutLimit::eventually) {
    const CheckedRules checked = rules_of(rules);
    std::string text;
    for_each_question(checked, {without, {}, nullptr}, [&](const ConflictAnswer& answer) {
        if (answer.conflict == Answer::no) return;
        text += text.empty() ? "" : " ";
        for (const std::size_t rule : answer.rules) text += (rule == answer.rules[0] ? "" : "-") + checked.name(rule);
        if (answer.conflict == Answer::not_decided) text += "?";
    });
    return text;
}

TEST(SleecConflicts, WindowsMeetOrNot) {
    const std::string within5 = "A when Go then Stop within 5 seconds\n";
    EXPECT_EQ(conflicts(within5 + "B when Go then not Stop within 4 seconds"), "A-B")
        << "B from a Go at 1 second later";
    EXPECT_EQ(conflicts("A when Go then Stop within 5 seconds\nB Stop at least 5 seconds after Halt"), "A-B")
        << "Halt a second after Go";
    EXPECT_EQ(conflicts(within5 + "B when Go then Stop within 3 seconds"), "");
    EXPECT_EQ(conflicts(within5 + "B when Go then not Alarm within 9 seconds"), "");
    EXPECT_EQ(conflicts("A when Go then Stop\nB when Go then not Stop within 9 hours"), "") << "later";
    EXPECT_EQ(conflicts("A when Go then Stop\nB when Halt then not Stop"), "A-B") << "never again";
}

/// `_` matches each value. Events with different values are different events.
TEST(SleecConflicts, OfArguments) {
    const std::string one = "A when Go(1) then Stop(1) within 5 seconds\n";
    EXPECT_EQ(conflicts(one + "B when Halt then not Stop(2) within 9 seconds"), "");
    EXPECT_EQ(conflicts(one + "B when Halt then not Stop(_) within 9 seconds"), "A-B");
    EXPECT_EQ(conflicts(one + "B when Halt then not Stop(1) within 9 seconds"), "A-B");
    const std::string any = "A when Go then Stop(_) within 5 seconds\n";
    EXPECT_EQ(conflicts(any + "B when Halt then not Stop(1) within 9 seconds"), "") << "another value";
    EXPECT_EQ(conflicts(any + "B when Halt then not Stop(_) within 9 seconds"), "A-B");
    EXPECT_EQ(conflicts("A when Go then Stop(_) within 5 seconds\nB when Halt then not Stop(true) within 9 seconds\n"
                        "C when Alarm then not Stop(false) within 9 seconds"),
              "A-B-C")
        << "there is no third truth value";
}

TEST(SleecConflicts, ArgumentsMakeRulesRedundant) {
    const auto redundant = [](const std::string& weak, const std::string& strong) {
        const CheckedRules rules = rules_of("A " + weak + "\nB " + strong);
        return is_redundant(rules, 0, 1, {});
    };
    EXPECT_TRUE(redundant("when Go(1) then Stop within 5 seconds", "when Go(_) then Stop within 5 seconds"));
    EXPECT_FALSE(redundant("when Go(_) then Stop within 5 seconds", "when Go(1) then Stop within 5 seconds"));
    EXPECT_TRUE(redundant("when Go then Stop(_) within 5 seconds", "when Go then Stop(1) within 5 seconds"));
    EXPECT_FALSE(redundant("when Go then Stop(1) within 5 seconds", "when Go then Stop(_) within 5 seconds"));
    EXPECT_TRUE(redundant("when Go then not Stop(1) within 5 seconds", "when Go then not Stop(_) within 5 seconds"));
    EXPECT_FALSE(redundant("when Go then not Stop(_) within 5 seconds", "when Go then not Stop(1) within 5 seconds"));
}

/// Fault 1 of SLEEC-TK is about `>=` on a scale. These verdicts are correct.
TEST(SleecConflicts, OfScales) {
    const std::string stop = "A1 when Go and load >= mid then Stop within 2 seconds\n";
    EXPECT_EQ(conflicts(stop + "A2 when Go and load = mid then not Stop within 5 seconds"), "A1-A2");
}

/// Fault 2 of SLEEC-TK is about a defeater inside a defeater. These verdicts are correct: a single Go causes no
/// conflict, but near and safe may change between two.
TEST(SleecConflicts, OfNestedDefeaters) {
    const std::string help =
        "B1 when Go then Alarm within 2 seconds unless near then {Help within 3 seconds unless safe}\n";
    EXPECT_EQ(conflicts(help + "B2 when Go and near and safe then not Help within 0 seconds"), "B1-B2")
        << "a second Go at the last instant";
    const CheckedRules rules = rules_of(help + "B2 when Go and near and safe then not Help within 4 seconds");
    const ConflictAnswer answer = find_conflict(rules, {0, 1}, {});
    ASSERT_EQ(answer.conflict, Answer::yes);
    EXPECT_NE(answer.example->due[0].values, answer.example->forbidding[0].values) << "never by one occurrence";
    EXPECT_EQ(conflicts("B1 when Go then Stop unless near then {Help within 3 seconds unless near}\n"
                        "B2 when Go then not Help within 4 seconds"),
              "")
        << "Help is never asked for";
}

/// Fault 3 of SLEEC-TK ignores that measures change between triggers. This verdict is correct.
TEST(SleecConflicts, OfMeasuresThatChange) {
    EXPECT_EQ(conflicts("C1 when Go and near then Stop within 10 seconds\n"
                        "C2 when Halt and not near then not Stop within 60 seconds"),
              "C1-C2");
}

/// Fault 4 of SLEEC-TK lets an active rule refuse its trigger. By the correct verdict, it does not.
TEST(SleecConflicts, NotOfTriggers) {
    EXPECT_EQ(conflicts("D1 when Go then Halt within 3 seconds\n"
                        "C2 when Halt and not near then not Stop within 60 seconds"),
              "");
}

/// Fault 5 of SLEEC-TK is about scales that share a value. These verdicts are correct.
TEST(SleecConflicts, OfScalesThatShareAValue) {
    Read read(
        "def_start event Go event Stop measure a : scale(low, moderate) measure b : scale(moderate, high) def_end\n"
        "rule_start R1 when Go and a = moderate then Stop within 1 seconds\n"
        "R2 when Go and b = moderate then not Stop within 3 seconds rule_end");
    ASSERT_TRUE(read.checked_too().checked) << read.report();
    EXPECT_EQ(find_conflict(*read.checked, {0, 1}, {}).conflict, Answer::yes);
}

/// Fault 6 of SLEEC-TK is about a conflict of three rules. No two of them are in conflict. These verdicts are correct.
TEST(SleecConflicts, OfThree) {
    const std::string alarm = "R1 when Go then Alarm within 5 seconds otherwise Help within 0 seconds\n";
    const std::string no_alarm = "R2 when Halt then not Alarm within 9 seconds\n";
    const std::string no_help = "R3 when Halt then not Help within 9 seconds\n";
    EXPECT_EQ(conflicts(alarm + no_alarm), "");
    EXPECT_EQ(conflicts(alarm + no_help), "");
    EXPECT_EQ(conflicts(alarm + no_alarm + no_help), "R1-R2-R3");
}

/// Fault 7 of SLEEC-TK is about measures that the rules do not distinguish. Here, the state space does not grow with
/// them.
TEST(SleecConflicts, AreFewStatesWithManyMeasures) {
    std::string text = "def_start event Go event Stop ";
    std::string all = "m0";
    for (int i = 0; i < 16; ++i) text += "measure m" + std::to_string(i) + " : boolean ";
    for (int i = 1; i < 16; ++i) all += " and m" + std::to_string(i);
    text += "def_end rule_start R1 when Go and " + all + " then Stop within 60 seconds\n";
    text += "R2 when Go then not Stop within 50 seconds unless not m0 rule_end";
    Read read(text);
    ASSERT_TRUE(read.checked_too().checked) << read.report();
    const ConflictAnswer answer = find_conflict(*read.checked, {0, 1}, {});
    EXPECT_EQ(answer.conflict, Answer::yes);
    EXPECT_LT(answer.states, 20'000U);
}

/// The alternatives of A remain possible until Alarm occurs at second 2. Alarm excludes the second alternative, so Stop
/// must occur at that instant, which B forbids. No rule requests this Alarm.
TEST(SleecConflicts, OfAlternativesThatAreGivenAway) {
    EXPECT_EQ(conflicts("A when Go then Stop within 2 seconds otherwise not Alarm within 3 seconds\n"
                        "B when Halt then not Stop within 1 seconds"),
              "A-B");
}

/// Two triggers of the same rule overlap: near is true at the first and false at the second.
TEST(SleecConflicts, OfARuleWithItself) {
    EXPECT_EQ(conflicts("R when Go then Stop within 3 seconds unless near then not Stop within 3 seconds"), "R");
    EXPECT_EQ(conflicts("R when Go then Stop within 3 seconds unless near then not Stop within 3 seconds unless near"),
              "");
}

/// Only histories that satisfy the rules so far count. In the first example, Stop has to occur immediately, which also
/// fulfils the duty of A.
TEST(SleecConflicts, OnlyInHistoriesThatKeepTheRules) {
    EXPECT_EQ(conflicts("A when Go then Stop within 5 seconds\n"
                        "B when Go then Stop within 0 seconds unless near then not Stop within 9 seconds"),
              "B A-B");
    EXPECT_EQ(conflicts("A when Go then Stop within 5 seconds\n"
                        "assume N when Go then not Halt\nB when Halt then not Stop within 9 seconds"),
              "A-B")
        << "Halt before Go";
    EXPECT_EQ(conflicts("A when Go then Stop within 5 seconds unless Halt\nB when Halt then not Stop within 9 seconds"),
              "A-B")
        << "Halt before Go";
    EXPECT_EQ(conflicts("A when Go then Stop within 5 seconds unless Halt\nB when Halt then not Stop within 4 seconds"),
              "")
        << "before Go it is over in time; after it the duty ends";
    EXPECT_EQ(conflicts("A when Go then Stop within 5 seconds\nB when Go then not Stop within 0 seconds"), "A-B");
    EXPECT_EQ(conflicts("A when Go then Stop within [1, 5] seconds\nB when Halt then not Alarm"), "");
}

TEST(SleecConflicts, WithoutLimitNow) {
    EXPECT_EQ(conflicts("A when Go then Stop\nB when Halt then not Stop", WithoutLimit::now), "A-B");
    EXPECT_EQ(conflicts("A when Go then Stop within 5 minutes\nB when Halt then not Stop", WithoutLimit::now), "A-B");
    EXPECT_EQ(conflicts("A when Go then Stop otherwise not Stop\nB when Halt then not Stop", WithoutLimit::now), "");
}

TEST(SleecConflicts, ShowTheSituation) {
    const CheckedRules rules = rules_of(
        "A when Go and near then Stop within 2 seconds\n"
        "B when Halt then Alarm within 3 seconds otherwise not Stop within 4 seconds");
    const ConflictAnswer answer = find_conflict(rules, {0, 1}, {});
    ASSERT_EQ(answer.conflict, Answer::yes);
    const Conflict& found = *answer.example;
    EXPECT_EQ(found.due.at(0).rule, 0U);
    EXPECT_EQ(found.forbidding.at(0).rule, 1U);
    EXPECT_EQ(found.due[0].values[0], 1) << "near";
    EXPECT_EQ(found.instant, found.due[0].began + 2);
    EXPECT_GE(found.instant, found.forbidding[0].began + 4) << "Alarm was missed";
    EXPECT_LE(found.instant, found.forbidding[0].began + 7);
}

/// If the search reaches a limit, the answer is undecided, never "no".
TEST(SleecConflicts, AreNotDecidedWithinTooFewStates) {
    const CheckedRules rules =
        rules_of("A when Go then Stop within 50 seconds\nB when Halt then not Stop within 9 seconds");
    AnalysisOptions options;
    options.limits.max_states = 5;
    EXPECT_EQ(find_conflict(rules, {0, 1}, options).conflict, Answer::not_decided);
}

// ---------------------------------------------------------------- redundancy

bool redundant(const std::string& rule, const std::string& by, WithoutLimit without = WithoutLimit::eventually) {
    return is_redundant(rules_of("R1 " + rule + "\nR2 " + by), 0, 1, {without, {}, nullptr});
}

/// Three alternatives end at the same instant, and three rules exclude one each. Without one of these rules, an
/// alternative remains.
TEST(SleecConflicts, OfFour) {
    const std::string due =
        "A when Go then Stop within 2 seconds otherwise Alarm within 0 seconds otherwise Help within 0 seconds\n";
    const std::string others =
        "B when Halt then not Stop within 9 seconds\nC when Halt then not Alarm within 9 seconds\n";
    EXPECT_EQ(conflicts(due + others + "D when Halt then not Help within 9 seconds"), "A-B-C-D");
    EXPECT_EQ(conflicts(due + others + "D when Halt and near then not Help within 1 seconds"), "A-B-C-D");
    EXPECT_EQ(conflicts(due + others), "");
}

/// The rule itself excludes one alternative, and another rule excludes the other.
TEST(SleecConflicts, OfARuleWithItselfAndAnother) {
    const std::string own =
        "A when Go then Stop within 2 seconds otherwise Alarm within 0 seconds unless near then {not Stop within 9 "
        "seconds}\n";
    EXPECT_EQ(conflicts(own), "");
    EXPECT_EQ(conflicts(own + "B when Halt then not Alarm within 9 seconds"), "A-B");
}

TEST(SleecConflicts, OfInstantsWithoutEnd) {
    const std::string go = "A when Go then Stop within 0 seconds\n";
    EXPECT_EQ(conflicts(go + "B when Stop then Go within 0 seconds"), "A-B");
    EXPECT_EQ(conflicts(go + "B when Stop then Go within 1 seconds"), "") << "a second passes";
    EXPECT_EQ(conflicts(go + "B when Stop and near then Go within 0 seconds"), "") << "nobody need be near";
    EXPECT_EQ(conflicts(go + "B when Stop then Go within 0 seconds otherwise Help within 0 seconds"), "")
        << "Help leads out";
    EXPECT_EQ(conflicts(go + "B when Stop then Halt within 0 seconds\nC when Halt then Go within 0 seconds"), "A-B-C");
    EXPECT_EQ(conflicts("A when Go then Go within 0 seconds"), "A");
    EXPECT_EQ(conflicts("A when Go then Stop\nB when Stop then Go", WithoutLimit::now), "A-B");
}

std::string suggested(const std::string& rules, std::vector<std::size_t> in_conflict) {
    std::string text;
    for (const Suggestion& suggestion : suggest_defeaters(rules_of(rules), in_conflict, {}))
        text += (text.empty() ? "" : ", ") + std::to_string(suggestion.rule) + " " + suggestion.text;
    return text;
}

TEST(SleecConflicts, SuggestWhatRemovesThem) {
    const std::string both = "A when Go then Stop within 5 seconds\nB when Halt then not Stop within 9 seconds";
    EXPECT_EQ(suggested(both, {0, 1}), "0 unless Halt, 1 unless Go") << "whichever comes first, it ends";
    EXPECT_EQ(suggested("A when Go then Stop within 5 seconds\nB when Go then not Stop within 9 seconds", {0, 1}), "")
        << "one trigger, and nothing is measured";
    const std::string itself = "A when Go then Stop within 5 seconds unless near then {not Stop within 9 seconds}";
    EXPECT_EQ(suggested(itself, {0}), "0 unless near");
}

TEST(SleecRedundancy, IsImplicationByTheSameTrigger) {
    EXPECT_TRUE(redundant("when Go then Stop within 5 seconds", "when Go then Stop within 3 seconds"));
    EXPECT_FALSE(redundant("when Go then Stop within 3 seconds", "when Go then Stop within 5 seconds"));
    EXPECT_TRUE(redundant("when Go then Stop", "when Go then Stop within 5 seconds"));
    EXPECT_FALSE(redundant("when Go then Stop within 5 seconds", "when Go then Stop"));
    EXPECT_TRUE(redundant("when Go and near then Stop", "when Go then Stop"));
    EXPECT_FALSE(redundant("when Go then Stop", "when Go and near then Stop"));
    EXPECT_TRUE(redundant("when Go then not Stop within 3 seconds", "when Go then not Stop within 5 seconds"));
    EXPECT_FALSE(redundant("when Go then not Stop within 5 seconds", "when Go then not Stop within 3 seconds"));
    EXPECT_FALSE(redundant("when Go then Stop", "when Halt then Stop"));
    EXPECT_TRUE(redundant("when Go then Stop unless near", "when Go then Stop"));
    EXPECT_FALSE(redundant("when Go then Stop", "when Go then Stop unless near"));
    EXPECT_TRUE(redundant("when Go then Stop within 3 seconds otherwise Alarm within 2 seconds",
                          "when Go then Stop within 1 seconds"));
    EXPECT_TRUE(redundant("when Go then Stop within 3 seconds otherwise Stop within 4 seconds",
                          "when Go then Stop within 7 seconds"));
    EXPECT_TRUE(redundant("when Go and near and not near then Stop", "when Halt then Stop")) << "asks for nothing";
    EXPECT_TRUE(redundant("when Go then Stop otherwise not Stop", "when Halt then Stop", WithoutLimit::now));
}

TEST(SleecRedundancy, KnowsRulesThatAskForNothing) {
    EXPECT_TRUE(makes_no_demand(rules_of("R when Go and level > 3 and level < 4 then Stop"), 0, {}));
    EXPECT_FALSE(makes_no_demand(rules_of("R when Go and level > 3 then Stop"), 0, {}));
}

}  // namespace
}  // namespace robochart::sleec
