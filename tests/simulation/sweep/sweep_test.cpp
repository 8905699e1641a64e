// SPDX-License-Identifier: Apache-2.0
// Tests points of a sweep, the sets that follow from their verdicts, and tables. The verdicts are given by hand.
#include "simulation/sweep/sweep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simulation/scenario/read_scenario.hpp"
#include "simulation/sweep/sweep_plot.hpp"
#include "simulation/sweep/sweep_report.hpp"

namespace robochart::simulation {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* varied = R"(scenario S for M {
	step 0.1 s physics 0.1 s unit 0.1 s duration 10 s seed 7
	arena square with 400 cm2 per robot
	robots 2 { place random in arena }
	measure spread is spread
	accept each spread <= 1 cm
	accept probability spread <= 5 cm within 10 s >= 90 % with confidence 95 %
	vary robots in 1 to 4
	vary const reach in 0.25, 0.1
})";

struct ReadScenario {
    explicit ReadScenario(const std::string& text) {
        scenario = read_scenario(sources, sources.add("s.scenario", text), diagnostics);
        for (const auto& finding : diagnostics.sorted_findings())
            findings += std::string(finding.rule->code) + " " + finding.message() + "\n";
    }
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    Scenario scenario;
    std::string findings;
};

std::string with(const std::string& line) {
    std::string text = varied;
    const std::string old = "vary robots in 1 to 4";
    return text.replace(text.find(old), old.size(), line);
}

TEST(Vary, ReadsValues) {
    const auto values = [](const std::string& line) {
        const ReadScenario read(with(line));
        EXPECT_EQ(read.findings, "") << line;
        return read.scenario.variations.empty() ? std::vector<double>{} : read.scenario.variations.front().values;
    };
    EXPECT_THAT(values("vary robots in 1 to 4"), ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(values("vary robots in 10 to 50 by 20"), ElementsAre(10, 30, 50));
    EXPECT_THAT(values("vary robots in 9, 3, 9"), ElementsAre(3, 9));
    const auto noise = values("vary noise in 0 % to 30 % by 10 %");
    ASSERT_EQ(noise.size(), 4U);
    EXPECT_NEAR(noise[3], 0.3, 1e-12);
    EXPECT_TRUE(ReadScenario(with("vary robots in 1 to 4 until proved")).scenario.variations.at(0).until_proved);
    const ReadScenario read(varied);
    EXPECT_FALSE(read.scenario.variations.at(0).until_proved);
    EXPECT_EQ(read.scenario.variations.at(1).constant, "reach");
    EXPECT_THAT(read.scenario.variations[1].values, ElementsAre(0.1, 0.25));
}

TEST(Vary, Failures) {
    const std::string failing =
        "failure of motors at 1 s in 2 robots failure of all with mean time 9 s vary failures in 0 to 2 "
        "vary mean time in 5 s, 60 s";
    std::string text = with(failing);
    text.erase(text.find("\tvary const"), text.rfind('}') - text.find("\tvary const"));
    const ReadScenario read(text);
    EXPECT_EQ(read.findings, "");
    const Scenario at = scenario_at(read.scenario, {2, 60});
    EXPECT_EQ(at.failures.at(0).robots, 2U);
    EXPECT_EQ(at.failures[0].mean_time, 0);
    EXPECT_EQ(at.failures.at(1).mean_time, 60);
    EXPECT_EQ(point_text(read.scenario, {0, 5}), "failures 0, mean time 5");
    EXPECT_THAT(ReadScenario(with("vary failures in 0 to 3")).findings,
                HasSubstr("RC-M04 the scenario does not state the failure"));
    EXPECT_THAT(ReadScenario(with("vary mean time in 3 s")).findings,
                HasSubstr("RC-M04 the scenario does not state the failure"));
}

TEST(Vary, Findings) {
    EXPECT_THAT(ReadScenario(with("vary wind in 1 to 4")).findings,
                HasSubstr("RC-M01 expected 'robots', 'noise', 'failures', 'mean time', 'const' or a sensor"));
    EXPECT_THAT(ReadScenario(with("vary robots in 4 to 1")).findings,
                HasSubstr("RC-M03 a variation has 1 to 1000 values"));
    EXPECT_THAT(ReadScenario(with("vary robots in 1 to 100000")).findings, HasSubstr("RC-M03 a variation has"));
    EXPECT_THAT(ReadScenario(with("vary noise in 0 % to 1 %")).findings, HasSubstr("RC-M01 expected 'by'"));
    EXPECT_THAT(ReadScenario(with("vary robots in 0 to 3")).findings, HasSubstr("RC-M03"));
    EXPECT_THAT(ReadScenario(with("vary const reach in 1")).findings, HasSubstr("RC-M05 'const reach in 0.25, 0.1'"));
    EXPECT_THAT(ReadScenario(with("vary noise in 1 % vary robots in 1")).findings,
                HasSubstr("RC-M03 at most 2 things vary"));
}

TEST(Sweep, PointsAndTheirScenarios) {
    const ReadScenario read(varied);
    const auto points = points_of(read.scenario);
    ASSERT_EQ(points.size(), 8U);
    EXPECT_THAT(points[0], ElementsAre(1, 0.1));
    EXPECT_THAT(points[1], ElementsAre(2, 0.1)) << "the first variation changes fastest";
    EXPECT_THAT(points[7], ElementsAre(4, 0.25));
    const Scenario there = scenario_at(read.scenario, points[7]);
    EXPECT_EQ(there.robots, 4U);
    EXPECT_DOUBLE_EQ(there.world.arena.width, 40);
    EXPECT_TRUE(there.bands.empty());
    EXPECT_THAT(constants_at(read.scenario, points[7]), ElementsAre("reach=0.25"));
    EXPECT_EQ(point_text(read.scenario, points[7]), "robots 4, reach 0.25");
}

ClaimResult found(ClaimVerdict verdict) {
    ClaimResult result;
    result.verdict = verdict;
    result.interval = {0.25, 0.75};
    result.successes = 8;
    for (int i = 0; i < 16; ++i) result.outcomes.push_back({i < 8, i < 8 ? 1.0 + i : 10.0, i == 15});
    result.looked = 16;
    result.steps = 1234;
    return result;
}

ClaimVerdict verdict_of(char letter) {
    if (letter == 'h') return ClaimVerdict::holds;
    return letter == 'f' ? ClaimVerdict::fails : ClaimVerdict::open;
}

/// Returns verdicts at 1, 2, ... robots. The letters are 'h' for holds, 'f' for fails, 'o' for open, and '-' for not
/// simulated.
std::vector<PointResult> verdicts(const std::string& letters) {
    std::vector<PointResult> results;
    for (const char letter : letters) {
        PointResult point{{static_cast<double>(results.size() + 1)}, {}};
        if (letter != '-') point.claims.push_back(found(verdict_of(letter)));
        results.push_back(point);
    }
    return results;
}

std::string least_of(const std::string& letters) {
    const Least result = least_value(verdicts(letters), 0, std::nullopt);
    return (result.value ? std::to_string(static_cast<int>(*result.value)) : "none") +
           (result.certain ? " certain" : "") + (result.ended ? " ended" : "");
}

TEST(Sweep, TheLeastIsCertainWhereAllBelowAreRefuted) {
    EXPECT_EQ(least_of("ffhh"), "3 certain ended");
    EXPECT_EQ(least_of("ffh-"), "3 certain ended");
    EXPECT_EQ(least_of("fohh"), "3 ended") << "2 may hold as well";
    EXPECT_EQ(least_of("ff--"), "none");
    EXPECT_EQ(least_of("ffff"), "none ended");
    EXPECT_EQ(least_of("f-hh"), "3 ended");
    EXPECT_EQ(least_of("hfhf"), "1 certain ended") << "nothing is assumed of what lies above";
}

TEST(Sweep, EachValueOfTheSecondVariationHasItsLeast) {
    std::vector<PointResult> results;
    for (const auto& [robots, noise, verdict] :
         {std::tuple(1.0, 0.0, ClaimVerdict::fails), std::tuple(2.0, 0.0, ClaimVerdict::holds),
          std::tuple(1.0, 0.1, ClaimVerdict::holds), std::tuple(2.0, 0.1, ClaimVerdict::open)})
        results.push_back({{robots, noise}, {found(verdict)}});
    EXPECT_EQ(least_value(results, 0, 0.0).value, 2);
    EXPECT_EQ(least_value(results, 0, 0.1).value, 1);
}

TEST(Sweep, WhatIsKeptComesBack) {
    const std::vector<ClaimResult> claims{found(ClaimVerdict::holds), found(ClaimVerdict::open)};
    const auto back = claims_from_text(claims_to_text(claims), 2);
    ASSERT_TRUE(back);
    EXPECT_EQ(claims_to_text(*back), claims_to_text(claims));
    EXPECT_EQ((*back)[0].interval, claims[0].interval);
    EXPECT_EQ((*back)[0].trial_count(), 16U);
    EXPECT_EQ((*back)[0].stopped_count(), 1U);
    EXPECT_FALSE(claims_from_text(claims_to_text(claims), 3));
    EXPECT_FALSE(claims_from_text("not that", 2));
    EXPECT_FALSE(claims_from_text("[[1],[2]]", 2));
    EXPECT_FALSE(claims_from_text(R"([["a",1,0,0,1,1,1,[]],[0,1,0,0,1,1,1,[]]])", 2));
}

TEST(Sweep, TablesAndSets) {
    ReadScenario read(varied);
    read.scenario.variations.pop_back();
    SweepResult result;
    result.points = verdicts("ffho");
    const std::string text = sweep_text(read.scenario, result);
    EXPECT_THAT(text, HasSubstr("jointly for 4 points"));
    EXPECT_THAT(text, HasSubstr("  3         proved         16         8  25 % to 75 %           8.0 s (1 stopped)\n"));
    EXPECT_THAT(text, HasSubstr("  proved     3\n  refuted    1 to 2\n  open       4\n"));
    EXPECT_THAT(least_lines(read.scenario, result), ElementsAre("least robots: 3"));
    // Each point needs 1234 control steps, with 1, 2, 3 and 4 robots. Full trials would need 16 trials of 100 steps.
    EXPECT_EQ(result.robot_steps(read.scenario), 12'340U);
    EXPECT_EQ(result.whole_robot_steps(read.scenario), 16'000U);
    EXPECT_THAT(sweep_csv(read.scenario, result), HasSubstr(",proved,16,8,0.25,0.75,"));
    EXPECT_THAT(sweep_trials_csv(read.scenario, result), HasSubstr("\n3,1,22,0,10,1\n"));
    const auto plots = sweep_plots(read.scenario, result);
    ASSERT_EQ(plots.size(), 2U);
    EXPECT_EQ(plots[0].name, "success");
    EXPECT_EQ(plots[1].name, "times");
}

/// In a plot 100 % is at the top and 0 % at the bottom, and the ends of each interval are at its bounds.
TEST(SweepPlots, BarsAreAtTheirShares) {
    ReadScenario read(varied);
    read.scenario.variations.pop_back();
    SweepResult result;
    result.points = verdicts("h---");
    result.points[0].claims[0].interval = {0, 1};
    const std::string svg = sweep_plots(read.scenario, result)[0].svg;
    const std::size_t bar = svg.find("sim-target\" d=\"M");
    ASSERT_NE(bar, std::string::npos);
    double x = 0, low = 0, high = 0;
    ASSERT_EQ(std::sscanf(svg.c_str() + bar, "sim-target\" d=\"M%lf %lfV%lf", &x, &low, &high), 3);
    EXPECT_NEAR(low - high, 260, 0.2);
    EXPECT_THAT(svg, HasSubstr(">100 %</text>"));
    EXPECT_THAT(svg, HasSubstr(">0 %</text>"));
}

}  // namespace
}  // namespace robochart::simulation
