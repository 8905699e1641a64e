// SPDX-License-Identifier: Apache-2.0
// Tests estimates after a fixed number of trials, and comparisons of sweeps with tables. Counts and p-values are
// computed by hand.
#include "simulation/sweep/comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/statistics/binomial.hpp"
#include "simulation/scenario/read_scenario.hpp"

namespace robochart::simulation {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* estimating = R"(scenario S for M {
	step 0.1 s physics 0.1 s unit 0.1 s duration 10 s seed 7 trials 10
	arena square with 400 cm2 per robot
	robots 2 { place random in arena }
	sensor eye is line_of_sight
	measure spread is spread
	estimate probability spread <= 5 cm within 10 s with confidence 95 %
	vary robots in 1 to 3
	vary eye.error in 0 % to 10 % by 5 %
})";

struct Sweeping {
    explicit Sweeping(const std::string& text = estimating) {
        scenario = read_scenario(sources, sources.add("s.scenario", text), diagnostics);
        for (const auto& finding : diagnostics.sorted_findings()) findings += finding.message() + "\n";
    }
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    Scenario scenario;
    std::string findings;
};

ClaimResult estimated(const Claim& claim, std::uint64_t successes) {
    ClaimJudge judge(claim, 1);
    for (std::uint64_t trial = 0; !judge.is_done(); ++trial) judge.add({trial < successes, 1, false}, 10);
    return judge.result();
}

TEST(Estimates, AreIntervalsAfterAllTrials) {
    Sweeping read;
    ASSERT_EQ(read.findings, "");
    ASSERT_EQ(read.scenario.claims.size(), 1U);
    const ClaimResult found = estimated(read.scenario.claims[0], 4);
    EXPECT_EQ(found.verdict, ClaimVerdict::estimated);
    EXPECT_EQ(found.trial_count(), 10U);
    EXPECT_EQ(found.interval, statistics::clopper_pearson(4, 10, 1 - read.scenario.claims[0].confidence));
    read.scenario.set_trials(25);
    EXPECT_EQ(estimated(read.scenario.claims[0], 25).trial_count(), 25U);
    EXPECT_EQ(read.scenario.claims[0].text, "probability spread <= 5 cm within 10 s with confidence 95 %");
}

TEST(Estimates, ClaimNothing) {
    std::string text = estimating;
    text.replace(text.find(" with confidence"), 0, " >= 5 %");
    EXPECT_THAT(Sweeping(text).findings, HasSubstr("expected 'with'"));
}

TEST(Vary, SharesOfSensors) {
    const Sweeping read;
    EXPECT_EQ(name_of(read.scenario.variations[1]), "eye.error");
    EXPECT_EQ(value_text(read.scenario.variations[1], 0.05), "5 %");
    const Scenario there = scenario_at(read.scenario, {2, 0.05});
    EXPECT_DOUBLE_EQ(there.sensors[0].false_negative, 0.05);
    EXPECT_DOUBLE_EQ(there.sensors[0].false_positive, 0.05);
    std::string text = estimating;
    text.replace(text.find("eye.error"), 9, "eye.leak ");
    EXPECT_THAT(Sweeping(text).findings, HasSubstr("there is no share of 'eye' named 'leak'"));
}

/// Returns a sweep with one point for each number of successes out of ten.
SweepResult sweep(const Scenario& scenario, const std::vector<std::uint64_t>& successes) {
    SweepResult result;
    for (const std::uint64_t count : successes)
        result.points.push_back(
            {{static_cast<double>(result.points.size() + 1)}, {estimated(scenario.claims[0], count)}});
    return result;
}

TEST(Comparison, TestsEachPointAndAllTogether) {
    Sweeping read;
    read.scenario.variations.pop_back();
    std::string error;
    const auto table = read_table("note,robots,successes,trials\nx,1,0,10\ny,3,5,10\n\"a, b\",2,0,10\nz,9,1,1\n",
                                  read.scenario, error);
    ASSERT_TRUE(table) << error;
    const auto all = compare_tables(read.scenario, sweep(read.scenario, {10, 0, 4}), *table);
    ASSERT_EQ(all.size(), 3U) << "9 robots are not here";
    // Ten of ten is compared with none of ten. The p-value is 2 of (20 choose 10) divisions, and there are three tests.
    EXPECT_NEAR(all[0].chance, 2.0 / 184'756, 1e-12);
    EXPECT_NEAR(all[0].adjusted, 6.0 / 184'756, 1e-12);
    EXPECT_TRUE(is_rejected(read.scenario, all[0]));
    EXPECT_NEAR(all[1].chance, 1, 1e-9);
    EXPECT_FALSE(is_rejected(read.scenario, all[1]));
    EXPECT_FALSE(is_rejected(read.scenario, all[2]));
    EXPECT_EQ(comparison_summary(read.scenario, all), "1 of 3 estimates differ from the table");
    EXPECT_THAT(comparison_text(read.scenario, all), HasSubstr("DIFFERS"));
}

TEST(Comparison, ItsOwnTableIsOne) {
    Sweeping read;
    read.scenario.variations.pop_back();
    const SweepResult result = sweep(read.scenario, {1, 2, 3});
    std::string error;
    const auto table = read_table(sweep_csv(read.scenario, result), read.scenario, error);
    ASSERT_TRUE(table) << error;
    ASSERT_EQ(table->size(), 3U);
    EXPECT_THAT((*table)[2].point, ElementsAre(3));
    EXPECT_EQ((*table)[2].sample.successes, 3U);
    EXPECT_EQ(comparison_summary(read.scenario, compare_tables(read.scenario, result, *table)),
              "none of 3 estimates differs from the table");
}

TEST(Comparison, WhatIsNoTable) {
    Sweeping read;
    const auto error_of = [&](const std::string& text) {
        std::string error;
        EXPECT_FALSE(read_table(text, read.scenario, error)) << text;
        return error;
    };
    EXPECT_EQ(error_of(""), "it has no rows");
    EXPECT_EQ(error_of("robots,trials,successes\n"), "it has no column 'eye.error'");
    EXPECT_EQ(error_of("robots,eye.error,trials\n"), "it has no columns 'trials' and 'successes'");
    const std::string head = "robots,eye.error,trials,successes\n";
    EXPECT_EQ(error_of(head), "it has no rows");
    EXPECT_EQ(error_of(head + "1,0,10,3\n1,0,3,10\n"), "line 3 is not a row of this table") << "more than all";
    EXPECT_EQ(error_of(head + "one,0,10,3\n"), "line 2 is not a row of this table");
    EXPECT_EQ(error_of(head + "1,0,10\n"), "line 2 is not a row of this table");
    EXPECT_EQ(error_of(head + "1,0,-1,-1\n"), "line 2 is not a row of this table");
}

}  // namespace
}  // namespace robochart::simulation
