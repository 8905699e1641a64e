// All trials of a scenario on the threads that are there, their measures against the bands, and their answers to
// claims. Results depend on the scenario alone, not on the number of threads: claims are judged in the order of seeds.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "simulation/report/claims.hpp"
#include "simulation/trial/trial.hpp"

namespace robochart::simulation {

/// How far the trials of a scenario have come.
struct RunProgress {
    std::uint32_t trials = 0;  ///< with claims, at most so many
    std::uint32_t trials_done = 0;
    double simulated_seconds = 0;  ///< of all trials so far
    double total_seconds = 0;      ///< of all trials in the end, none of them shortened
    double seconds = 0;            ///< of this run
};

/// How the trials of a scenario are run.
struct RunOptions {
    unsigned threads = 0;  ///< 0: one a core
    StageMaker stage = embedded_stage;
    bool record = true;  ///< keep positions, of the first `recorded_trials`
    /// The errors of claims are divided by this: they are about so many values of a sweep and hold together.
    std::uint32_t comparisons = 1;
    /// Makes what sees a trial's cycles; called from the trial's thread. Empty: nothing does.
    std::function<std::unique_ptr<Trace>(std::uint32_t trial)> trace;
    std::function<bool()> interrupted;                 ///< asked a few times a second
    std::function<void(const RunProgress&)> progress;  ///< called a few times a second, from the caller's thread
};

/// Whether the trials lie in one band.
struct BandResult {
    bool holds = false;
    double value = 0;                ///< of `mean`: the mean; of `each`: the worst trial; NaN: a time that never came
    std::size_t trials_outside = 0;  ///< of `each`
};

/// All trials of a scenario and what the bands and claims say of them.
struct RunResult {
    std::vector<TrialResult> trials;  ///< those of the scenario's `trials`, for bands and pictures
    std::vector<BandResult> bands;
    std::vector<ClaimResult> claims;
    bool interrupted = false;
    bool watched = true;           ///< TrialResult::watched of all trials that bands and claims rest on
    bool stops_are_errors = true;  ///< else, where only claims are asked, a trial that stops is one against them
    std::uint64_t steps = 0;       ///< control steps of these trials, and of those that were only for claims
    double seconds = 0;            ///< on the clock
    double cpu_seconds = 0;        ///< of all threads

    /// A controller stopped a trial, and that is an error.
    [[nodiscard]] bool stopped() const;
    /// A band or a claim fails, or a controller stopped.
    [[nodiscard]] bool fails() const;
    /// All trials complete and watched, all bands and all claims hold. Neither holds nor fails: a claim is open, or not
    /// all was watched.
    [[nodiscard]] bool holds() const;
};

/// The trials that go on to their ends: those of the scenario, but where only claims are asked and nothing is kept.
[[nodiscard]] std::uint32_t whole_trials(const Scenario&, bool record);

/// How many trials keep their positions: all, but at most a hundred, and no more than memory bears.
[[nodiscard]] std::uint32_t recorded_trials(const Scenario&);

/// Runs them. Diagnostics: robots that do not fit, controllers that stopped.
[[nodiscard]] RunResult run(const Plan&, const Drives&, const RunOptions&, diagnostics::Diagnostics&);

/// The bands of a scenario on finished trials.
[[nodiscard]] std::vector<BandResult> judge(const Scenario&, const std::vector<TrialResult>&);

}  // namespace robochart::simulation
