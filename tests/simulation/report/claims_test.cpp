// SPDX-License-Identifier: Apache-2.0
// Tests claims on given answers, with the number of trials that the interval or the test needs, and on simulated
// trials, with any number of threads.
#include "simulation/report/claims.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "simulation/scenario/read_scenario.hpp"
#include "tests/simulation/harness.hpp"

namespace robochart::simulation {
namespace {

using testing::Experiment;
using testing::replaced;

Claim at_least(double probability, double confidence, std::uint32_t most = 10'000) {
    Claim claim;
    claim.probability = probability;
    claim.confidence = confidence;
    claim.trials = most;
    return claim;
}

/// Decides a claim with as many trials as it needs. Every `period`-th trial fails, or none if `period` is 0.
ClaimResult judged(const Claim& claim, std::uint64_t period, std::uint32_t comparisons = 1) {
    ClaimJudge judge(claim, comparisons);
    for (std::uint64_t trial = 1; !judge.is_done(); ++trial)
        judge.add({period == 0 || trial % period != 0, 1, false}, 10);
    return judge.result();
}

/// Without a failure the lower bound after n trials is (share of the error / 2)^(1/n). The seventh look, after 183
/// trials, has 1/56 of the error, and its bound is the first above 95 %.
TEST(Claims, HoldAtTheFirstLookThatShowsIt) {
    const ClaimResult found = judged(at_least(0.95, 0.99), 0);
    EXPECT_EQ(found.verdict, ClaimVerdict::holds);
    EXPECT_EQ(found.trial_count(), 183U);
    EXPECT_EQ(found.successes, 183U);
    EXPECT_NEAR(found.interval.low, std::pow(0.01 / 56 / 2, 1 / 183.0), 1e-7);
    EXPECT_EQ(found.steps, 1830U);
    EXPECT_LT(std::pow(0.01 / 42 / 2, 1 / 122.0), 0.95) << "the look before";
}

TEST(Claims, FailAndStayOpen) {
    const ClaimResult none = judged(at_least(0.95, 0.99), 1);
    EXPECT_EQ(none.verdict, ClaimVerdict::fails);
    EXPECT_EQ(none.trial_count(), 16U) << "the first look";
    EXPECT_NEAR(none.interval.high, 1 - std::pow(0.01 / 4, 1 / 16.0), 1e-7);
    const ClaimResult few = judged(at_least(0.95, 0.99, 10), 0);
    EXPECT_EQ(few.verdict, ClaimVerdict::open);
    EXPECT_EQ(few.trial_count(), 10U);
    EXPECT_NEAR(few.interval.low, std::pow(0.005, 0.1), 1e-7) << "one look with the whole error";
    EXPECT_EQ(judged(at_least(0.5, 0.99, 2000), 2).verdict, ClaimVerdict::open) << "half of them succeed";
}

TEST(Claims, AtMost) {
    Claim claim = at_least(0.1, 0.95);
    claim.at_least = false;
    EXPECT_EQ(judged(claim, 1).verdict, ClaimVerdict::holds);
    EXPECT_EQ(judged(claim, 0).verdict, ClaimVerdict::fails);
}

/// Each point of a sweep gets a share of the total error.
TEST(Claims, ComparisonsShareTheError) {
    const ClaimResult found = judged(at_least(0.95, 0.99), 0, 30);
    EXPECT_EQ(found.trial_count(), 275U);
    EXPECT_NEAR(found.interval.low, std::pow(0.01 / 30 / 72 / 2, 1 / 275.0), 1e-7);
}

/// 86 is the first n with n ln(.95/.90) >= ln 100.
TEST(Claims, WithAnIndifferenceAreTested) {
    Claim claim = at_least(0.925, 0.99);
    claim.indifference = 0.025;
    EXPECT_EQ(judged(claim, 0).trial_count(), 86U);
    EXPECT_EQ(judged(claim, 0).verdict, ClaimVerdict::holds);
    EXPECT_EQ(judged(claim, 1).verdict, ClaimVerdict::fails);
    EXPECT_EQ(judged(claim, 1).trial_count(), 7U) << "n ln(.10/.05) >= ln 100";
    claim.trials = 50;
    EXPECT_EQ(judged(claim, 0).verdict, ClaimVerdict::open);
}

TEST(Claims, TextSaysWhatTheyRestOn) {
    Scenario scenario;
    scenario.claims.push_back(at_least(0.95, 0.99));
    scenario.claims.back().text = "probability P >= 95 % with confidence 99 %";
    EXPECT_EQ(claims_text(scenario, {judged(scenario.claims[0], 0)}),
              "  holds    probability P >= 95 % with confidence 99 %\n"
              "           183 of 183 trials; between 95.032 % and 100 %\n");
    scenario.claims[0].trials = 10;
    EXPECT_EQ(claims_text(scenario, {judged(scenario.claims[0], 0)}),
              "  open     probability P >= 95 % with confidence 99 %\n"
              "           10 of 10 trials; between 58.87 % and 100 %; no more trials are allowed\n");
}

// ---------------------------------------------------------------- simulated trials

constexpr const char* model = R"(
interface Ops { forward() }
stm Go {
	requires Ops
	initial i
	state Going { entry forward() }
	transition t0 { from i to Going }
}
)";

/// One robot drives straight ahead for 10 s at 10 cm/s, from a random place within 50 cm of a lamp and with a random
/// heading.
constexpr const char* scenario = R"(
scenario World for Go {
	step 0.1 s physics 0.1 s unit 0.1 s duration 10 s trials 3 seed 5
	arena 500 cm by 500 cm open
	light lamp at (0 cm, 0 cm)
	robots 1 { place random in (-50 cm, -50 cm) to (50 cm, 50 cm) }
	actuator motors is differential_drive
	drive motors by forward(10 cm/s) on forward
	measure way is distance(lamp)
	accept probability way <= 20 cm within 10 s >= 20 % with confidence 95 %
	accept probability way >= 60 cm within 10 s >= 70 % with confidence 95 %
	accept probability not (way <= 5 cm within 10 s) >= 50 % with confidence 95 %, indifference 5 %
}
)";

RunResult run(Experiment& experiment, unsigned threads, bool record) {
    std::string error;
    if (experiment.controller == nullptr) experiment.controller = Controller::build(experiment.emission, "", error);
    EXPECT_EQ(error, "");
    RunOptions options;
    options.threads = threads;
    options.record = record;
    return simulation::run_trials(experiment.plan, experiment.controller->drive(), options, experiment.diagnostics);
}

std::string described(const RunResult& result) {
    std::string text = std::to_string(result.steps) + "\n";
    for (const ClaimResult& claim : result.claims) {
        text += verdict_word(claim.verdict) + " " + std::to_string(claim.successes) + " " +
                std::to_string(claim.interval.low) + " " + std::to_string(claim.steps) + ":";
        for (const ClaimOutcome& outcome : claim.outcomes)
            text += (outcome.holds ? " +" : " -") + std::to_string(outcome.time);
        text += "\n";
    }
    return text;
}

TEST(ClaimsOfTrials, AreTheSameWithAnyNumberOfThreads) {
    Experiment experiment(model, scenario);
    ASSERT_EQ(experiment.codes(), "") << experiment.messages();
    const std::string one = described(run(experiment, 1, false));
    for (const unsigned threads : {2U, 3U, 8U}) EXPECT_EQ(described(run(experiment, threads, false)), one);
    EXPECT_THAT(one, ::testing::HasSubstr("holds"));
}

/// Trials that are recorded for pictures run to their end, but give the same answers.
TEST(ClaimsOfTrials, DoNotDependOnWhatIsKept) {
    Experiment experiment(model, scenario);
    const RunResult recorded = run(experiment, 2, true);
    const RunResult bare = run(experiment, 2, false);
    ASSERT_EQ(recorded.trials.size(), 3U);
    EXPECT_EQ(recorded.trials[1].steps, 100U);
    EXPECT_TRUE(bare.trials.empty());
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(recorded.claims[c].trial_count(), bare.claims[c].trial_count());
        EXPECT_EQ(recorded.claims[c].successes, bare.claims[c].successes);
        EXPECT_EQ(recorded.claims[c].steps, bare.claims[c].steps);
    }
    EXPECT_LE(bare.steps, recorded.steps);
    EXPECT_LT(bare.claims[1].steps, 100 * bare.claims[1].trial_count()) << "trials that succeed end then";
}

/// A robot that starts within 20 cm of the lamp succeeds immediately. Otherwise the robot drives straight at 10 cm/s,
/// which determines its distance after 10 s and the outcome of every trial.
TEST(ClaimsOfTrials, AreThoseOfTheStraightLine) {
    Experiment experiment(model, scenario);
    const RunResult result = run(experiment, 2, false);
    const auto& outcomes = result.claims[0].outcomes;
    for (std::uint32_t trial = 0; trial < outcomes.size(); ++trial) {
        const auto world = start(experiment.scenario, trial, experiment.diagnostics);
        const Vector from = world->position(0);
        bool reached = false;
        for (int step = 0; step <= 100; ++step)
            reached = reached || length(from + static_cast<double>(step) * world->direction(0)) <= 20;
        EXPECT_EQ(outcomes[trial].holds, reached) << trial;
    }
}

TEST(ClaimsOfTrials, ATrialThatStopsCountsAgainstThem) {
    const std::string loop = replaced(model, "transition t0", R"(state B { }
	transition t1 { from Going to B }
	transition t2 { from B to Going }
	transition t0)");
    Experiment experiment(loop, scenario);
    ASSERT_EQ(experiment.codes(), "") << experiment.messages();
    const RunResult result = run(experiment, 2, false);
    EXPECT_FALSE(result.stops_are_errors);
    EXPECT_TRUE(experiment.diagnostics.ok());
    // The answer is known at the start, so the trial counts. A later answer cannot occur.
    EXPECT_EQ(result.claims[1].verdict, ClaimVerdict::fails);
    EXPECT_EQ(result.claims[1].trial_count(), 16U);
    EXPECT_EQ(result.claims[1].stopped_count() + result.claims[1].successes, 16U);
    EXPECT_GE(result.claims[1].stopped_count(), 8U);
    EXPECT_EQ(result.claims[2].verdict, ClaimVerdict::fails) << "whatever is claimed of it";
    EXPECT_TRUE(result.has_failed());
    Experiment most(loop, replaced(scenario, "60 cm within 10 s >= 70 %", "60 cm within 10 s <= 70 %"));
    EXPECT_EQ(run(most, 1, false).claims[1].verdict, ClaimVerdict::fails) << "against it too";
    // In a scenario with bands, it remains an error if a trial stops.
    Experiment band(loop, replaced(scenario, "measure way is distance(lamp)",
                                   "measure way is distance(lamp)\n\taccept each way >= 0 cm"));
    const RunResult stopped = run(band, 1, false);
    EXPECT_TRUE(stopped.stops_are_errors);
    EXPECT_TRUE(stopped.has_stopped_trial());
    EXPECT_EQ(band.codes(), "RC-M12 RC-M12 RC-M12");
}

}  // namespace
}  // namespace robochart::simulation
