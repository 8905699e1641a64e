// SPDX-License-Identifier: Apache-2.0
#include "simulation/report/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <mutex>

#include "base/threads/threads.hpp"
#include "simulation/scenario/rules.hpp"

namespace robochart::simulation {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double cpu_now() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

class Runner {
public:
    Runner(const Plan& plan, const Drives& drives, const RunOptions& options)
        : plan_(plan),
          scenario_(*plan.scenario),
          drives_(drives),
          options_(options),
          whole_(whole_trials(scenario_, options.record)),
          most_(whole_) {
        for (const Claim& claim : scenario_.claims) {
            judges_.emplace_back(claim, options.comparisons);
            most_ = std::max(most_, claim.trials);
        }
        trials_.resize(most_);
    }

    RunResult run(diagnostics::Diagnostics& diagnostics) {
        const double cpu = cpu_now();
        diagnostics::in_parallel_watched(
            thread_count(), [this] { run_worker(); }, [this] { stop_ = enough_ = true; }, [this] { watch_workers(); });
        result_.seconds = seconds_since(start_);
        result_.cpu_seconds = cpu_now() - cpu;
        result_.interrupted = stop_.load();
        result_.stops_are_errors = !scenario_.bands.empty() || scenario_.claims.empty();
        for (const ClaimJudge& judge : judges_) result_.claims.push_back(judge.result());
        result_.watched = all_trials_watched();
        for (Done& done : trials_) {
            const bool whole = result_.trials.size() < whole_;
            result_.steps += whole ? done.trial.steps : done.needed;
            if (whole) result_.trials.push_back(std::move(done.trial));
        }
        report_problems(diagnostics);
        if (!result_.interrupted && diagnostics.ok() && whole_ > 0)
            result_.bands = judge_bands(scenario_, result_.trials);
        return std::move(result_);
    }

private:
    [[nodiscard]] unsigned thread_count() const {
        return std::min<unsigned>(diagnostics::threads_wanted(options_.threads), most_);
    }

    struct Done {
        TrialResult trial;
        diagnostics::Diagnostics found;
        bool ended = false;
        std::uint64_t needed = 0;  ///< steps until the claims that use the trial had their answers
    };

    void run_worker() {
        for (std::uint32_t trial = next_++; trial < most_ && !stop_; trial = next_++) {
            const std::vector<bool> awaited = still_awaited();
            if (trial >= whole_ && std::ranges::count(awaited, true) == 0) break;
            run_one(trial, awaited);
            const std::lock_guard lock(mutex_);
            end_trial(trial);
        }
    }

    /// Returns the claims that the trials so far do not decide. A later trial must answer at least these claims.
    std::vector<bool> still_awaited() {
        const std::lock_guard lock(mutex_);
        std::vector<bool> awaited;
        for (const ClaimJudge& judge : judges_) awaited.push_back(!judge.is_done());
        return awaited;
    }

    void run_one(std::uint32_t trial, const std::vector<bool>& awaited) {
        Done& done = trials_[trial];
        const auto stage = options_.stage(scenario_, trial, done.found);
        if (stage == nullptr) {
            stop_ = true;  // the problem occurs in all trials
            return;
        }
        TrialOptions options;
        options.seed = scenario_.seed + trial;
        options.record = options_.record && trial < recorded_trials(scenario_);
        if (trial >= whole_) options.awaited = &awaited;
        const std::unique_ptr<Trace> trace = options_.trace ? options_.trace(trial) : nullptr;
        options.trace = trace.get();
        options.steps_done = &steps_;
        options.interrupted = trial < whole_ ? &stop_ : &enough_;
        done.trial = run_trial(plan_, drives_, *stage, options);
        done.trial.watched = trace == nullptr || trace->is_conclusive();
    }

    /// Ends a trial: evaluates the claims on the finished trials, in order, up to the first unfinished one.
    void end_trial(std::uint32_t trial) {
        const TrialResult& result = trials_[trial].trial;
        trials_[trial].ended = result.complete || result.stop;
        if (trials_[trial].ended) ++done_;
        for (; judged_ < most_ && trials_[judged_].ended; ++judged_) judge_next(trials_[judged_]);
        const bool decided = std::ranges::all_of(judges_, [](const ClaimJudge& judge) { return judge.is_done(); });
        if (decided || stop_) enough_ = true;
    }

    void judge_next(Done& done) {
        for (std::size_t c = 0; c < judges_.size(); ++c) {
            if (judges_[c].is_done()) continue;
            const Answer& answer = done.trial.answers.at(c);
            const double time = static_cast<double>(answer.step) * scenario_.world.control_step;
            judges_[c].add({answer.holds.value(), time, answer.taken}, answer.step);
            done.needed = std::max(done.needed, answer.step);
        }
    }

    /// Checks for interruption and reports progress while the workers run.
    void watch_workers() {
        if (options_.interrupted && options_.interrupted()) stop_ = enough_ = true;
        const std::lock_guard lock(mutex_);
        if (options_.progress) options_.progress(current_progress());
    }

    /// Returns true if the observers saw everything in the trials that the results use. Threads may have started
    /// further trials, which are ignored.
    [[nodiscard]] bool all_trials_watched() const {
        std::uint64_t used_trials = whole_;
        for (const ClaimResult& claim : result_.claims)
            used_trials = std::max<std::uint64_t>(used_trials, claim.trial_count());
        const auto end =
            trials_.begin() + static_cast<std::ptrdiff_t>(std::min<std::uint64_t>(used_trials, trials_.size()));
        return std::all_of(trials_.begin(), end, [](const Done& done) { return done.trial.watched; });
    }

    [[nodiscard]] RunProgress current_progress() const {
        RunProgress now;
        now.trials = most_;
        now.trials_done = done_;
        now.simulated_seconds = static_cast<double>(steps_.load()) * scenario_.world.control_step;
        now.total_seconds = most_ * scenario_.duration;
        now.seconds = seconds_since(start_);
        return now;
    }

    void report_problems(diagnostics::Diagnostics& diagnostics) const {
        // All trials have the same problem, so one report is enough.
        const auto bad = std::ranges::find_if(trials_, [](const Done& done) { return !done.found.ok(); });
        if (bad != trials_.end())
            for (const diagnostics::Diagnostic& d : bad->found.sorted_findings())
                diagnostics.report(*d.rule, d.span, d.arguments);
        if (!result_.stops_are_errors) return;
        for (std::size_t trial = 0; trial < result_.trials.size(); ++trial) {
            const auto& stop = result_.trials[trial].stop;
            if (!stop) continue;
            diagnostics.report(rules::stopped, scenario_.component.span,
                               {stop->owner_text(), std::to_string(trial + 1), fmt::format("{:.1f}", stop->time),
                                stop->cause, stop->place});
        }
    }

    const Plan& plan_;
    const Scenario& scenario_;
    const Drives& drives_;
    const RunOptions& options_;
    const Clock::time_point start_ = Clock::now();
    const std::uint32_t whole_;  ///< trials that run to their end
    std::uint32_t most_;
    std::vector<Done> trials_;
    RunResult result_;
    std::atomic<std::uint32_t> next_ = 0;
    std::atomic<std::uint64_t> steps_ = 0;
    std::atomic<bool> stop_ = false;    ///< interrupted, or no trial can run
    std::atomic<bool> enough_ = false;  ///< stop_, or all claims are decided: trials only for claims may end
    std::mutex mutex_;                  ///< protects the members below
    std::vector<ClaimJudge> judges_;
    std::uint32_t judged_ = 0;  ///< number of trials that were evaluated
    std::uint32_t done_ = 0;
};

/// Returns the distance of a value from a band; infinite for a time that was never reached.
double distance_from_band(const Band& band, double value) {
    if (std::isnan(value)) return std::numeric_limits<double>::infinity();
    return std::max({0.0, band.low - value, value - band.high});
}

/// Returns the finite end of a band, or the middle if both ends are finite.
double middle_of(const Band& band) {
    if (std::isinf(band.low)) return band.high;
    return std::isinf(band.high) ? band.low : (band.low + band.high) / 2;
}

BandResult judge_each(const Band& band, std::size_t index, const std::vector<TrialResult>& trials) {
    BandResult result;
    const double middle = middle_of(band);
    const auto rank = [&](double value) {
        if (std::isnan(value)) return std::numeric_limits<double>::infinity();
        if (std::isinf(band.low)) return value - middle;
        return std::isinf(band.high) ? middle - value : std::abs(value - middle);
    };
    bool first = true;
    for (const TrialResult& trial : trials) {
        const double value = trial.statistics.at(index);
        if (distance_from_band(band, value) > 0) ++result.trials_outside;
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
    result.holds = distance_from_band(band, result.value) == 0;
    return result;
}

}  // namespace

bool RunResult::has_stopped_trial() const {
    return stops_are_errors &&
           std::ranges::any_of(trials, [](const TrialResult& trial) { return trial.stop.has_value(); });
}

bool RunResult::has_failed() const {
    return has_stopped_trial() || std::ranges::any_of(bands, [](const BandResult& band) { return !band.holds; }) ||
           std::ranges::any_of(claims, [](const ClaimResult& claim) { return claim.verdict == ClaimVerdict::fails; });
}

bool RunResult::all_hold() const {
    return !has_failed() && !interrupted && watched &&
           std::ranges::none_of(claims, [](const ClaimResult& claim) { return claim.verdict == ClaimVerdict::open; });
}

std::uint32_t whole_trials(const Scenario& scenario, bool record) {
    return record || !scenario.bands.empty() || scenario.claims.empty() ? scenario.trials : 0;
}

std::vector<BandResult> judge_bands(const Scenario& scenario, const std::vector<TrialResult>& trials) {
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
    const double trials = std::floor(most_poses / (frames * scenario.all_robots()));
    return static_cast<std::uint32_t>(std::clamp(trials, 0.0, std::min(100.0, static_cast<double>(scenario.trials))));
}

RunResult run_trials(const Plan& plan, const Drives& drives, const RunOptions& options,
                     diagnostics::Diagnostics& diagnostics) {
    return Runner(plan, drives, options).run(diagnostics);
}

}  // namespace robochart::simulation
