// SPDX-License-Identifier: Apache-2.0
// Compares measures with values computed by hand, and bands over several trials.
#include "simulation/trial/measures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>

#include <cmath>

#include "simulation/report/report.hpp"
#include "simulation/report/run.hpp"

namespace robochart::simulation {
namespace {

std::vector<Pose> at(const std::vector<Vector>& places) {
    std::vector<Pose> poses;
    for (const Vector place : places) poses.push_back({place, 0});
    return poses;
}

TEST(Measures, ClusterFollowsChains) {
    // Three robots are in a row with distances of ten, and one is alone. With a distance of ten they are linked, with
    // nine they are not.
    const auto poses = at({{0, 0}, {20, 0}, {10, 0}, {0, 50}});
    EXPECT_DOUBLE_EQ(largest_cluster(poses, 10), 0.75);
    EXPECT_DOUBLE_EQ(largest_cluster(poses, 9.99), 0.25);
    EXPECT_DOUBLE_EQ(largest_cluster(poses, 60), 1);
}

/// Compares clusters with the transitive closure of the relation.
TEST(MeasuresProperty, ClusterIsTheClosure) {
    Random random(5);
    for (int round = 0; round < 200; ++round) {
        std::vector<Vector> places;
        for (int i = 0; i < 25; ++i) places.push_back({random.uniform(0, 100), random.uniform(0, 100)});
        std::vector<std::size_t> group(places.size());
        for (std::size_t i = 0; i < places.size(); ++i) group[i] = i;
        for (std::size_t pass = 0; pass < places.size(); ++pass)
            for (std::size_t i = 0; i < places.size(); ++i)
                for (std::size_t j = 0; j < places.size(); ++j)
                    if (length(places[i] - places[j]) <= 15) group[i] = group[j] = std::min(group[i], group[j]);
        std::size_t largest = 0;
        for (std::size_t i = 0; i < places.size(); ++i)
            largest = std::max(largest, static_cast<std::size_t>(std::ranges::count(group, i)));
        EXPECT_DOUBLE_EQ(largest_cluster(at(places), 15), static_cast<double>(largest) / 25);
    }
}

TEST(Measures, ClustersCountThoseAloneToo) {
    const auto poses = at({{0, 0}, {20, 0}, {10, 0}, {0, 50}});
    EXPECT_EQ(count_clusters(poses, 10).count, 2U) << "the three, and the one alone";
    EXPECT_EQ(count_clusters(poses, 10).largest, 3U);
    EXPECT_EQ(count_clusters(poses, 9.99).count, 4U);
    EXPECT_EQ(count_clusters(poses, 60).count, 1U);
    EXPECT_EQ(count_clusters({}, 60).count, 0U);
}

TEST(Measures, MeanDistanceIsOverAllPairs) {
    // The three robots form a triangle with sides 3, 4 and 5.
    EXPECT_DOUBLE_EQ(mean_distance(at({{0, 0}, {3, 0}, {0, 4}})), 4);
    EXPECT_DOUBLE_EQ(mean_distance(at({{7, 7}})), 0);
}

TEST(Measures, SpreadAndMomentOfASquare) {
    const auto poses = at({{3, 4}, {-3, 4}, {3, -4}, {-3, -4}});
    EXPECT_DOUBLE_EQ(mean_spread(poses), 5);
    EXPECT_DOUBLE_EQ(second_moment(poses, 2.5), 4 * 25 / 25.0);
    EXPECT_EQ(centroid(poses), (Vector{0, 0}));
}

Scenario with_bands() {
    Scenario scenario;
    scenario.name.text = "Test";
    scenario.duration = 2;
    Measure& spread_of = scenario.measures.emplace_back();
    spread_of.name.text = "spread";
    spread_of.kind = MeasureKind::spread;
    const Formula at_least_five{Formula::Kind::compare, 0, 5, INFINITY, 0, {}};
    scenario.bands.push_back({{StatisticKind::first_time, 0, 0, at_least_five}, true, -INFINITY, 1, "each", {}});
    scenario.bands.push_back({{StatisticKind::average, 0, 0, {}}, false, 2, 4, "mean", {}});
    scenario.bands.push_back({{StatisticKind::at_time, 0, 0.5, {}}, false, 0, 9, "mean", {}});
    return scenario;
}

TEST(Statistics, TimesAveragesAndMoments) {
    const Scenario scenario = with_bands();
    Statistics statistics(scenario);
    for (std::uint64_t step = 0; step <= 20; ++step) {
        // Two robots move apart by 2 cm per step, so the spread is the number of steps.
        const double half = static_cast<double>(step);
        const Frame frame{0, at({{-half, 0}, {half, 0}}), {}, {}};
        statistics.take_samples(step, measures_now(scenario, frame));
    }
    const auto values = statistics.band_values();
    EXPECT_NEAR(values[0], 0.5, 1e-12) << "5 is reached after five steps of 0.1 s";
    EXPECT_NEAR(values[1], (0 + 10 + 20) / 3.0, 1e-12) << "at 0, 1 and 2 s";
    EXPECT_NEAR(values[2], 5, 1e-12);
}

TEST(Judge, EachTakesTheWorstMeanTheMean) {
    const Scenario scenario = with_bands();
    std::vector<TrialResult> trials(2);
    trials[0].statistics = {0.5, 3, 1};
    trials[1].statistics = {NAN, 4.5, 1};
    const auto bands = judge_bands(scenario, trials);
    EXPECT_FALSE(bands[0].holds);
    EXPECT_TRUE(std::isnan(bands[0].value)) << "never is the worst";
    EXPECT_EQ(bands[0].trials_outside, 1U);
    EXPECT_TRUE(bands[1].holds);
    EXPECT_DOUBLE_EQ(bands[1].value, 3.75);
    trials[1].statistics[0] = 0.9;
    EXPECT_TRUE(judge_bands(scenario, trials)[0].holds);
    EXPECT_DOUBLE_EQ(judge_bands(scenario, trials)[0].value, 0.9);
}

}  // namespace
}  // namespace robochart::simulation
