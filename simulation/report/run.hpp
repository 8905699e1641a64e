// All trials of a scenario on the threads that are there, and their measures against the bands. Results depend on the
// scenario alone, not on the number of threads.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "simulation/trial/trial.hpp"

namespace robochart::simulation {

/// How far the trials of a scenario have come.
struct RunProgress {
    std::uint32_t trials = 0;
    std::uint32_t trials_done = 0;
    double simulated_seconds = 0;  ///< of all trials so far
    double total_seconds = 0;      ///< of all trials in the end
    double seconds = 0;            ///< of this run
};

/// How the trials of a scenario are run.
struct RunOptions {
    unsigned threads = 0;  ///< 0: one a core
    StageMaker stage = embedded_stage;
    bool record = true;  ///< keep positions, of the first `recorded_trials`
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

/// All trials of a scenario and what the bands say of them.
struct RunResult {
    std::vector<TrialResult> trials;
    std::vector<BandResult> bands;
    bool interrupted = false;
    double seconds = 0;      ///< on the clock
    double cpu_seconds = 0;  ///< of all threads

    [[nodiscard]] bool stopped() const;
    /// All trials complete and all bands hold.
    [[nodiscard]] bool holds() const;
};

/// How many trials keep their positions: all, but at most a hundred, and no more than memory bears.
[[nodiscard]] std::uint32_t recorded_trials(const Scenario&);

/// Runs them. Diagnostics: robots that do not fit, controllers that stopped.
[[nodiscard]] RunResult run(const Plan&, const rc_drive&, const RunOptions&, diagnostics::Diagnostics&);

/// The bands of a scenario on finished trials.
[[nodiscard]] std::vector<BandResult> judge(const Scenario&, const std::vector<TrialResult>&);

}  // namespace robochart::simulation
