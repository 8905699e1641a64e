// SPDX-License-Identifier: Apache-2.0
// Runs all trials of a scenario on several threads, compares their measures with the bands, and answers claims. Results
// depend only on the scenario, not on the number of threads, because claims are decided in the order of seeds.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "simulation/report/claims.hpp"
#include "simulation/trial/trial.hpp"

namespace robochart::simulation {

/// How far the trials of a scenario have advanced.
struct RunProgress {
    std::uint32_t trials = 0;  ///< if there are claims: the maximum
    std::uint32_t trials_done = 0;
    double simulated_seconds = 0;  ///< over all trials so far
    double total_seconds = 0;      ///< over all trials at the end, if none is shortened
    double seconds = 0;            ///< elapsed time of this run
};

/// Options for the trials of a scenario.
struct RunOptions {
    unsigned threads = 0;  ///< 0: one per core
    StageMaker stage = embedded_stage;
    bool record = true;  ///< stores positions of the first `recorded_trials`
    /// The number of points of a sweep that share the errors of claims. Each error is divided by it, so that the claims
    /// hold jointly at all points.
    std::uint32_t comparisons = 1;
    /// Makes the observer of a trial's cycles. Called from the trial's thread; may be empty.
    std::function<std::unique_ptr<Trace>(std::uint32_t trial)> trace;
    std::function<bool()> interrupted;                 ///< called a few times per second
    std::function<void(const RunProgress&)> progress;  ///< called a few times per second, in the caller's thread
};

/// The result of one band.
struct BandResult {
    bool holds = false;
    double value = 0;                ///< `mean`: the mean; `each`: the worst trial; NaN: a time that was never reached
    std::size_t trials_outside = 0;  ///< `each`: the number of trials outside the band
};

/// All trials of a scenario and the results for bands and claims.
struct RunResult {
    std::vector<TrialResult> trials;  ///< the scenario's `trials`, for bands and pictures
    std::vector<BandResult> bands;
    std::vector<ClaimResult> claims;
    bool interrupted = false;
    bool watched = true;           ///< TrialResult::watched of all trials that bands and claims use
    bool stops_are_errors = true;  ///< false if there are only claims, for which a stopped trial is a failure
    std::uint64_t steps = 0;       ///< number of control steps of `trials` and of the trials that run only for claims
    double seconds = 0;            ///< elapsed time
    double cpu_seconds = 0;        ///< CPU time of all threads

    /// True if a controller stopped a trial and this is an error.
    [[nodiscard]] bool has_stopped_trial() const;
    /// True if a band or a claim fails, or a controller stopped.
    [[nodiscard]] bool has_failed() const;
    /// True if all trials are complete and observed, and all bands and claims hold. If neither has_failed() nor
    /// all_hold() is true, a claim is open, or some trial is not complete or was not completely observed.
    [[nodiscard]] bool all_hold() const;
};

/// Returns the number of trials that run to their end: the number in the scenario, or 0 if there are only claims and no
/// trial is stored.
[[nodiscard]] std::uint32_t whole_trials(const Scenario&, bool record);

/// Returns the number of trials whose positions are stored: all trials, but at most a hundred, and only as many as
/// memory allows.
[[nodiscard]] std::uint32_t recorded_trials(const Scenario&);

/// Runs the trials. Reports robots that do not fit, and controllers that stopped.
[[nodiscard]] RunResult run_trials(const Plan&, const Drives&, const RunOptions&, diagnostics::Diagnostics&);

/// Compares finished trials with the bands of the scenario.
[[nodiscard]] std::vector<BandResult> judge_bands(const Scenario&, const std::vector<TrialResult>&);

}  // namespace robochart::simulation
