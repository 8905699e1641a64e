// SPDX-License-Identifier: Apache-2.0
// Counts the work of one check, and compares it with the limits while the check runs.
#pragma once

#include <chrono>
#include <ctime>
#include <functional>
#include <string>

#include "base/diagnostics/budget.hpp"
#include "checker/process/operational_semantics.hpp"
#include "checker/refine/search/limits.hpp"

namespace robochart::refine {

using diagnostics::LimitReached;

/// The moments at which Budget::call_after may call its function.
enum class CallMoment : std::uint8_t {
    any_poll,        ///< when any work polls the budget
    between_states,  ///< when a search calls Budget::between_states; the function may then use the searched systems
};

/// The limits of one check: the budget of the run, with an additional limit on states. The search charges its work to
/// this object. The object also reports progress.
class Budget final : public diagnostics::Pollable {
public:
    explicit Budget(const Limits& limits, Progress::Phase phase = Progress::Phase::searching);

    /// Charges a unit of work, as charge() does.
    void poll() override { charge(); }
    /// Charges a unit of work, which is about the work of expanding a state. Throws LimitReached.
    void charge() {
        if ((work_++ & 1023U) == 0) check_and_report();
    }
    void charge(std::uint64_t pieces) {
        if (((work_ + pieces - 1) ^ (work_ - 1)) > 1023U) check_and_report();
        work_ += pieces;
    }
    /// Checks the limits of the run immediately. Throws LimitReached.
    void check() { run_.check(); }
    /// Checks immediately whether a limit of the run is reached or the run is interrupted, and returns true if so.
    [[nodiscard]] bool limit_reached() { return !run_.reached_limit().empty(); }
    /// Compares the number of stored states with the limit on states. Throws LimitReached.
    void states(std::uint64_t count) const;
    [[nodiscard]] double seconds() const;
    [[nodiscard]] const Limits& limits() const { return limits_; }
    /// Sets a function that provides the statistics for reports of progress. The function may be empty.
    void report_by(std::function<void(Progress&)> source) { source_ = std::move(source); }
    /// Calls the function once, after the program has used this much more CPU time. The function may throw an exception
    /// to end the work that polls the budget.
    void call_after(std::chrono::duration<double> cpu_time, CallMoment moment, std::function<void()> function);
    void cancel_call();
    /// Calls the function of call_after if its time has come. A search calls this while no thread uses the
    /// systems.
    void between_states() {
        if (call_is_due_) make_call();
    }
    /// Returns the number of threads that may work on the check, at least one.
    [[nodiscard]] unsigned threads() const;
    [[nodiscard]] std::size_t wide_level() const { return limits_.wide_level; }

private:
    using Time = std::chrono::steady_clock::time_point;

    void check_and_report();
    void make_call();
    void report_progress(Time now);

    const Limits& limits_;
    diagnostics::Budget run_;
    Progress::Phase phase_;
    Time start_;
    Time reported_;
    std::uint64_t resident_at_start_;
    std::uint64_t work_ = 0;
    std::function<void(Progress&)> source_;
    std::function<void()> call_;  // empty if nothing is to be called
    CallMoment call_moment_ = CallMoment::any_poll;
    std::clock_t call_time_ = 0;  // CPU time of the program at which the call is due
    bool call_is_due_ = false;    // the call waits for between_states
};

}  // namespace robochart::refine
