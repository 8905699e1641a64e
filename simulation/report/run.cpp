#include "simulation/report/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <ctime>
#include <limits>
#include <mutex>
#include <thread>

#include "simulation/scenario/rules.hpp"

namespace robochart::simulation {

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double cpu_now() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

class Runner {
public:
    Runner(const Plan& plan, const rc_drive& drive, const RunOptions& options)
        : plan_(plan), scenario_(*plan.scenario), drive_(drive), options_(options), found_(scenario_.trials) {
        result_.trials.resize(scenario_.trials);
    }

    RunResult run(diagnostics::Diagnostics& diagnostics) {
        const double cpu = cpu_now();
        std::vector<std::thread> workers;
        for (unsigned i = 0; i < threads(); ++i) workers.emplace_back([this] { work(); });
        watch();
        for (std::thread& worker : workers) worker.join();
        result_.seconds = since(start_);
        result_.cpu_seconds = cpu_now() - cpu;
        result_.interrupted = stop_.load();
        report(diagnostics);
        if (!result_.interrupted && diagnostics.ok()) result_.bands = judge(scenario_, result_.trials);
        return std::move(result_);
    }

private:
    [[nodiscard]] unsigned threads() const {
        const unsigned wanted =
            options_.threads > 0 ? options_.threads : std::max(1U, std::thread::hardware_concurrency());
        return std::min<unsigned>(wanted, scenario_.trials);
    }

    void work() {
        for (std::uint32_t trial = next_++; trial < scenario_.trials && !stop_; trial = next_++) {
            run_one(trial);
            const std::lock_guard lock(mutex_);
            ++done_;
            changed_.notify_one();
        }
        const std::lock_guard lock(mutex_);
        ++idle_;
        changed_.notify_one();
    }

    void run_one(std::uint32_t trial) {
        const auto stage = options_.stage(scenario_, trial, found_[trial]);
        if (stage == nullptr) return;
        TrialOptions options;
        options.seed = scenario_.seed + trial;
        options.record = options_.record && trial < recorded_trials(scenario_);
        const std::unique_ptr<Trace> trace = options_.trace ? options_.trace(trial) : nullptr;
        options.trace = trace.get();
        options.steps_done = &steps_;
        options.interrupted = &stop_;
        result_.trials[trial] = run_trial(plan_, drive_, *stage, options);
    }

    /// Waits for the workers; asks and tells meanwhile.
    void watch() {
        std::unique_lock lock(mutex_);
        while (idle_ < threads()) {
            changed_.wait_for(lock, std::chrono::milliseconds(100));
            if (options_.interrupted && options_.interrupted()) stop_ = true;
            if (options_.progress) options_.progress(progress());
        }
    }

    [[nodiscard]] RunProgress progress() const {
        RunProgress now;
        now.trials = scenario_.trials;
        now.trials_done = done_;
        now.simulated_seconds = static_cast<double>(steps_.load()) * scenario_.world.control_step;
        now.total_seconds = scenario_.trials * scenario_.duration;
        now.seconds = since(start_);
        return now;
    }

    void report(diagnostics::Diagnostics& diagnostics) const {
        // What one trial lacks the others lack as well.
        const auto bad = std::find_if(found_.begin(), found_.end(), [](const auto& found) { return !found.ok(); });
        if (bad != found_.end())
            for (const diagnostics::Diagnostic& d : bad->sorted()) diagnostics.report(*d.rule, d.span, d.arguments);
        for (std::size_t trial = 0; trial < result_.trials.size(); ++trial) {
            const auto& stop = result_.trials[trial].stop;
            if (!stop) continue;
            diagnostics.report(rules::stopped, scenario_.component.span,
                               {std::to_string(stop->robot), std::to_string(trial + 1),
                                fmt::format("{:.1f}", stop->time), stop->cause, stop->place});
        }
    }

    const Plan& plan_;
    const Scenario& scenario_;
    const rc_drive& drive_;
    const RunOptions& options_;
    const Clock::time_point start_ = Clock::now();
    std::vector<diagnostics::Diagnostics> found_;  ///< of each trial
    RunResult result_;
    std::atomic<std::uint32_t> next_ = 0;
    std::atomic<std::uint64_t> steps_ = 0;
    std::atomic<bool> stop_ = false;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::uint32_t done_ = 0;
    unsigned idle_ = 0;
};

/// How far a value is outside of a band; infinite for a time that never came.
double outside(const Band& band, double value) {
    if (std::isnan(value)) return std::numeric_limits<double>::infinity();
    return std::max({0.0, band.low - value, value - band.high});
}

BandResult judge_each(const Band& band, std::size_t index, const std::vector<TrialResult>& trials) {
    BandResult result;
    const double middle = std::isinf(band.low)    ? band.high
                          : std::isinf(band.high) ? band.low
                                                  : (band.low + band.high) / 2;
    const auto rank = [&](double value) {
        return std::isnan(value)       ? std::numeric_limits<double>::infinity()
               : std::isinf(band.low)  ? value - middle
               : std::isinf(band.high) ? middle - value
                                       : std::abs(value - middle);
    };
    bool first = true;
    for (const TrialResult& trial : trials) {
        const double value = trial.statistics.at(index);
        if (outside(band, value) > 0) ++result.trials_outside;
        if (first || rank(value) > rank(result.value)) result.value = value;
        first = false;
    }
    result.holds = result.trials_outside == 0;
    return result;
}

BandResult judge_mean(const Band& band, std::size_t index, const std::vector<TrialResult>& trials) {
    double sum = 0;
    for (const TrialResult& trial : trials) sum += trial.statistics.at(index);
    BandResult result;
    result.value = sum / static_cast<double>(trials.size());
    result.holds = outside(band, result.value) == 0;
    return result;
}

}  // namespace

bool RunResult::stopped() const {
    return std::any_of(trials.begin(), trials.end(), [](const TrialResult& trial) { return trial.stop.has_value(); });
}

bool RunResult::holds() const {
    return std::all_of(trials.begin(), trials.end(), [](const TrialResult& trial) { return trial.complete; }) &&
           std::all_of(bands.begin(), bands.end(), [](const BandResult& band) { return band.holds; });
}

std::vector<BandResult> judge(const Scenario& scenario, const std::vector<TrialResult>& trials) {
    std::vector<BandResult> results;
    for (std::size_t i = 0; i < scenario.bands.size(); ++i) {
        const Band& band = scenario.bands[i];
        results.push_back(band.each ? judge_each(band, i, trials) : judge_mean(band, i, trials));
    }
    return results;
}

std::uint32_t recorded_trials(const Scenario& scenario) {
    constexpr double most_poses = 4e7;  // about a gigabyte
    const double frames = scenario.duration / std::max(scenario.record, scenario.world.control_step) + 2 +
                          static_cast<double>(scenario.pictures.size());
    const double trials = std::floor(most_poses / (frames * scenario.robots));
    return static_cast<std::uint32_t>(std::clamp(trials, 0.0, std::min(100.0, static_cast<double>(scenario.trials))));
}

RunResult run(const Plan& plan, const rc_drive& drive, const RunOptions& options,
              diagnostics::Diagnostics& diagnostics) {
    return Runner(plan, drive, options).run(diagnostics);
}

}  // namespace robochart::simulation
