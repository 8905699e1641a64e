// SPDX-License-Identifier: Apache-2.0
// See trials.hpp.
#include "simulation/tuning/trials.hpp"

#include <algorithm>
#include <atomic>

#include "base/threads/threads.hpp"
#include "simulation/trial/trial.hpp"

namespace robochart::simulation {

namespace {

class Workers {
public:
    Workers(const std::vector<TuningTrial>& trials, unsigned threads) : trials_(trials), costs_(trials.size()) {
        count_ = static_cast<unsigned>(std::min<std::size_t>(diagnostics::threads_wanted(threads), trials.size()));
    }

    std::vector<double> run(const std::function<void()>& interrupted) {
        diagnostics::in_parallel_watched(
            count_, [this] { run_worker(); }, [this] { stop_ = true; }, interrupted);
        return std::move(costs_);
    }

private:
    void run_worker() {
        for (std::size_t t = next_++; t < trials_.size() && !stop_; t = next_++) costs_[t] = run_for_cost(trials_[t]);
    }

    [[nodiscard]] double run_for_cost(const TuningTrial& trial) const {
        Scenario scenario = *trial.plan->scenario;
        scenario.seed = trial.seed;
        Plan plan = *trial.plan;
        plan.scenario = &scenario;
        diagnostics::Diagnostics found;
        const auto stage = embedded_stage(scenario, 0, found);
        // Only the start of one trial was checked before. If the robots of another trial do not fit, the trial is a
        // failure of all claims.
        if (stage == nullptr) return trial_cost(scenario, std::vector<Answer>(scenario.claims.size()));
        const std::vector<bool> awaited(scenario.claims.size(), true);
        TrialOptions options;
        options.record = false;
        options.awaited = &awaited;
        options.seed = trial.seed;
        options.interrupted = &stop_;
        return trial_cost(scenario, run_trial(plan, *trial.drives, *stage, options).answers);
    }

    const std::vector<TuningTrial>& trials_;
    std::vector<double> costs_;
    unsigned count_ = 0;
    std::atomic<std::size_t> next_ = 0;
    std::atomic<bool> stop_ = false;
};

}  // namespace

std::uint64_t tuning_seed(const Scenario& scenario, std::uint64_t search, std::uint64_t number) {
    return scenario.seed + ((search + 1) << 32U) + number;
}

double trial_cost(const Scenario& scenario, const std::vector<Answer>& answers) {
    constexpr double penalty = 10;
    double cost = 0;
    for (std::size_t c = 0; c < scenario.claims.size(); ++c) {
        const Answer& answer = answers.at(c);
        const bool as_claimed = answer.holds && *answer.holds == scenario.claims[c].at_least;
        cost +=
            as_claimed ? static_cast<double>(answer.step) * scenario.world.control_step : penalty * scenario.duration;
    }
    return cost;
}

std::vector<double> trial_costs(const std::vector<TuningTrial>& trials, unsigned threads,
                                const std::function<void()>& interrupted) {
    return Workers(trials, threads).run(interrupted);
}

}  // namespace robochart::simulation
