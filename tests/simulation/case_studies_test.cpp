// SPDX-License-Identifier: Apache-2.0
// Tests the founding paper's two case studies with generated controllers. Ten trials of twenty robots stay within the
// bands, and faulty controllers do not. The bands come from hand-written controllers in Enki and ARGoS.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/statistics/binomial.hpp"
#include "harness.hpp"
#include "simulation/report/report.hpp"
#include "simulation/sweep/sweep.hpp"
#include "tests/needed.hpp"
#include "tests/source_folder.hpp"

namespace robochart::simulation {
namespace {

using testing::Experiment;
using testing::read_file;
using testing::replaced;

const std::string corpus = tests::source_folder().string() + "/corpus/";

std::string aggregation_model() {
    return read_file(corpus + "aggregation/aggregation.rct");
}
std::string aggregation_scenario() {
    return read_file(corpus + "aggregation/aggregation.scenario");
}
std::string taxis_model() {
    return read_file(corpus + "swarm_taxis/swarm_taxis.rct");
}
std::string taxis_scenario() {
    return read_file(corpus + "swarm_taxis/swarm_taxis.scenario");
}

void expect_held(const std::string& model, const std::string& scenario) {
    Experiment experiment(model, scenario);
    const RunResult result = experiment.run();
    EXPECT_EQ(result.trials.size(), 10U);
    EXPECT_TRUE(result.all_hold()) << bands_text(experiment.scenario, result);
}

void expect_broken(const std::string& model, const std::string& scenario) {
    Experiment experiment(model, scenario);
    const RunResult result = experiment.run();
    EXPECT_TRUE(experiment.diagnostics.ok()) << "it runs, " << experiment.messages();
    ASSERT_FALSE(result.bands.empty());
    EXPECT_FALSE(result.bands.front().holds) << "the first band, the claim of the paper\n"
                                             << bands_text(experiment.scenario, result);
}

TEST(Aggregation, OneClusterInAllTenTrials) {
    expect_held(aggregation_model(), aggregation_scenario());
}

/// Runs trials of a scenario of the aggregation study at one point of its sweep.
RunResult at_point(const std::string& name, double value, std::uint32_t trials) {
    Experiment experiment(aggregation_model(), read_file(corpus + "aggregation/" + name));
    experiment.scenario = scenario_at(experiment.scenario, {value});
    experiment.scenario.set_trials(trials);
    experiment.plan = bind_scenario(experiment.scenario, experiment.emission, experiment.diagnostics);
    return experiment.run();
}

/// Daymude, Harasha, Richa and Yiu, SSS 2021: without errors a symmetric ring never becomes compact, but with small
/// errors it does.
TEST(Aggregation, ASymmetricStartNeedsErrors) {
    EXPECT_EQ(at_point("symmetric.scenario", 0, 1).claims.at(0).successes, 0U);
    EXPECT_GE(at_point("symmetric.scenario", 0.1, 20).claims.at(0).successes, 15U);
}

/// Bjerknes and Winfield: at least nine of ten robots still work with probability p^10 + 10 p^9 (1 - p). This value is
/// within the joint intervals.
TEST(Aggregation, ReliabilityIsThatOfTheFormula) {
    constexpr double error = 0.01 / 5;
    for (const double mean : {60.0, 120.0, 240.0, 480.0, 960.0}) {
        const RunResult result = at_point("reliability.scenario", mean, 300);
        const ClaimResult& claim = result.claims.at(0);
        ASSERT_EQ(claim.trial_count(), 300U);
        const double expected = statistics::at_least(9, 10, std::exp(-20 / mean));
        const auto interval = statistics::clopper_pearson(claim.successes, 300, error);
        EXPECT_LE(interval.low, expected) << mean;
        EXPECT_GE(interval.high, expected) << mean;
    }
}

TEST(Aggregation, EventsSwappedFails) {
    std::string model = replaced(aggregation_model(), "S1 to S2 trigger seeRobot", "S1 to S2 trigger swapped");
    model = replaced(model, "S2 to S1 trigger seeWall", "S2 to S1 trigger seeRobot");
    expect_broken(replaced(model, "trigger swapped", "trigger seeWall"), aggregation_scenario());
}

TEST(Aggregation, NeverTurningFails) {
    expect_broken(replaced(aggregation_model(), "entry RotateClockwise(-5.02)", "entry MoveClockwise(-0.75, -10.88)"),
                  aggregation_scenario());
}

TEST(Aggregation, AlwaysTurningFails) {
    expect_broken(replaced(aggregation_model(), "entry MoveClockwise(-0.75, -10.88)", "entry RotateClockwise(-5.02)"),
                  aggregation_scenario());
}

TEST(Aggregation, StandingWhileSeeingFails) {
    expect_broken(
        replaced(aggregation_model(), "angularSpeed = angular; linearSpeed = 0;", "angularSpeed = 0; linearSpeed = 0;"),
        aggregation_scenario());
}

TEST(SwarmTaxis, ReachesTheBeaconTogether) {
    expect_held(taxis_model(), taxis_scenario());
}

TEST(SwarmTaxis, RadiiInvertedFails) {
    expect_broken(replaced(taxis_model(), "if illuminated then avoidanceRadius = 0.2 else avoidanceRadius = 0.1 end",
                           "if illuminated then avoidanceRadius = 0.1 else avoidanceRadius = 0.2 end"),
                  taxis_scenario());
}

TEST(SwarmTaxis, EqualRadiiFail) {
    expect_broken(replaced(taxis_model(), "avoidanceRadius = 0.2 else avoidanceRadius = 0.1 end",
                           "avoidanceRadius = 0.2 else avoidanceRadius = 0.2 end"),
                  taxis_scenario());
}

TEST(SwarmTaxis, NeverLitFails) {
    expect_broken(replaced(taxis_model(), "if illuminated then", "if false then"), taxis_scenario());
}

TEST(SwarmTaxis, WithoutCoherenceFails) {
    expect_broken(replaced(taxis_model(), "25", "25000"), taxis_scenario());
}

/// tests_enki is built only if Enki is installed. If it is absent in continuous integration, the test must fail.
TEST(CaseStudies, AreRunInEnkiToo) {
    ROBOCHART_NEEDS(ROBOCHART_TESTS_ENKI, "Enki (Debian: libenki-dev) for tests_enki");
}

TEST(CaseStudies, ResultsDoNotDependOnThreads) {
    Experiment experiment(aggregation_model(), replaced(aggregation_scenario(), "trials 10", "trials 4"));
    const RunResult one = experiment.run(1);
    const RunResult four = experiment.run(4);
    ASSERT_EQ(one.trials.size(), four.trials.size());
    for (std::size_t t = 0; t < one.trials.size(); ++t) {
        EXPECT_EQ(one.trials[t].statistics, four.trials[t].statistics);
        ASSERT_EQ(one.trials[t].frames.size(), four.trials[t].frames.size());
        for (std::size_t r = 0; r < 20; ++r)
            EXPECT_EQ(one.trials[t].frames.back().poses[r].at, four.trials[t].frames.back().poses[r].at);
    }
    EXPECT_NE(one.trials[0].frames.back().poses[0].at, one.trials[1].frames.back().poses[0].at) << "seeds differ";
}

/// The paper's figures show 0, 20, 40 and 60 seconds. The recorded states belong to the recorded positions.
TEST(CaseStudies, FramesAreKeptAtThePicturesTimes) {
    Experiment experiment(aggregation_model(), replaced(aggregation_scenario(), "record 0.5 s", "record 7 s"));
    const RunResult result = experiment.run();
    std::vector<double> times;
    for (const Frame& frame : result.trials[0].frames) times.push_back(frame.time);
    for (const double time : {0.0, 20.0, 40.0, 60.0, 180.0})
        EXPECT_THAT(times, ::testing::Contains(::testing::DoubleNear(time, 1e-9)));
    EXPECT_EQ(result.trials[0].frames.back().states.size(), 20U);
}

}  // namespace
}  // namespace robochart::simulation
