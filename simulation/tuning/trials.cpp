// See trials.hpp.
#include "simulation/tuning/trials.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "simulation/trial/trial.hpp"

namespace robochart::simulation {

namespace {

class Workers {
public:
    Workers(const std::vector<TuningTrial>& trials, unsigned threads) : trials_(trials), costs_(trials.size()) {
        const unsigned wanted = threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
        count_ = static_cast<unsigned>(std::min<std::size_t>(wanted, trials.size()));
    }

    std::vector<double> run(const std::function<void()>& interrupted) {
        std::vector<std::thread> threads;
        for (unsigned i = 0; i < count_; ++i) threads.emplace_back([this] { work(); });
        std::exception_ptr thrown;
        for (std::unique_lock lock(mutex_); ended_ < count_;) {
            changed_.wait_for(lock, std::chrono::milliseconds(100));
            if (thrown) continue;
            try {
                interrupted();
            } catch (...) {
                thrown = std::current_exception();
                stop_ = true;
            }
        }
        for (std::thread& each : threads) each.join();
        if (thrown) std::rethrow_exception(thrown);
        return std::move(costs_);
    }

private:
    void work() {
        for (std::size_t t = next_++; t < trials_.size() && !stop_; t = next_++) costs_[t] = cost(trials_[t]);
        const std::lock_guard lock(mutex_);
        ++ended_;
        changed_.notify_one();
    }

    [[nodiscard]] double cost(const TuningTrial& trial) const {
        Scenario scenario = *trial.plan->scenario;
        scenario.seed = trial.seed;
        Plan plan = *trial.plan;
        plan.scenario = &scenario;
        diagnostics::Diagnostics found;
        const auto stage = embedded_stage(scenario, 0, found);
        // One start was looked at before; where another does not fit, the robots cannot do what is claimed.
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
    std::mutex mutex_;  ///< of what follows
    std::condition_variable changed_;
    unsigned ended_ = 0;
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
