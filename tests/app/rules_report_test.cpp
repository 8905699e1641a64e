// SPDX-License-Identifier: Apache-2.0
// Tests the exit code and the last line of a report about rules, for answers that are hard to obtain from a small file.
#include "app/report/rules_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace robochart::app::rules_report_test {
namespace {

using ::testing::HasSubstr;

RulesReport two_rules() {
    RulesReport report;
    report.rules = {{"A", "rules.sleec:7"}, {"B", "rules.sleec:8"}};
    return report;
}

/// docs/rules-language.md: redundancies do not affect the exit code, and an undecided question gives 3.
TEST(RulesReport, OnlyUndecidedRedundanciesAffectTheExitCode) {
    RulesReport report = two_rules();
    EXPECT_EQ(exit_of(report), Exit::success);
    report.redundant = {{1, {0}, {}}};
    EXPECT_EQ(exit_of(report), Exit::success);
    EXPECT_THAT(rules_text(report, {}), HasSubstr("2 rules: 0 conflicts, 1 redundancy\n"));
    report.redundant.push_back({0, {}, "a limit was reached"});
    EXPECT_EQ(exit_of(report), Exit::inconclusive);
    EXPECT_THAT(rules_text(report, {}), HasSubstr("2 rules: 0 conflicts, 1 redundancy, 1 not decided\n"));
}

TEST(RulesReport, ErrorsPrecedeFailuresAndFailuresPrecedeOpenQuestions) {
    using Kind = driver::RuleVerdict::Kind;
    RulesReport report = two_rules();
    report.model = "model.rct";
    report.verdicts = {{"P::S", 0, Kind::not_decided, "a limit was reached", {}, 0}};
    EXPECT_EQ(exit_of(report), Exit::inconclusive);
    report.verdicts.push_back({"P::S", 1, Kind::broken, "", {}, 0});
    EXPECT_EQ(exit_of(report), Exit::failed);
    EXPECT_THAT(rules_text(report, {}), HasSubstr("2 verdicts: 1 broken, 1 not decided\n"));
    report.verdicts.push_back({"P::T", 1, Kind::error, "it cannot be evaluated", {}, 0});
    EXPECT_EQ(exit_of(report), Exit::bad_input);
    EXPECT_THAT(rules_text(report, {}), HasSubstr("3 verdicts: 1 broken, 1 not decided, 1 error\n"));
}

TEST(RulesReport, TimeThatStopsIsAFailure) {
    RulesReport report = two_rules();
    report.time_open = {"whether time can stop in P::S: a limit was reached"};
    EXPECT_EQ(exit_of(report), Exit::inconclusive);
    report.time_stops = {"P::S"};
    EXPECT_EQ(exit_of(report), Exit::failed);
}

}  // namespace
}  // namespace robochart::app::rules_report_test
