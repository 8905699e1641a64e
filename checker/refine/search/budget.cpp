// SPDX-License-Identifier: Apache-2.0
// Implements the limits of a check. The limit on memory refers to the resident memory of the whole program, because the
// searched states are stored in the systems and not in the search.
#include "checker/refine/search/budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/threads/threads.hpp"

namespace robochart::refine {
namespace {

constexpr std::chrono::milliseconds between_reports{100};

}  // namespace

Budget::Budget(const Limits& limits, Progress::Phase phase)
    : limits_(limits),
      run_(limits, phase == Progress::Phase::compiling ? "compiling" : ""),
      phase_(phase),
      start_(std::chrono::steady_clock::now()),
      reported_(start_),
      resident_at_start_(diagnostics::resident_bytes()) {}

void Budget::states(std::uint64_t count) const {
    constexpr std::uint64_t most_numbers = 4'000'000'000;  // states have 32-bit numbers; this leaves a margin
    const std::uint64_t most = std::min(limits_.max_states, most_numbers);
    if (count > most)
        throw LimitReached(fmt::format("the limit of {} states was reached{}", most,
                                       phase_ == Progress::Phase::compiling ? " while compiling" : ""));
}

double Budget::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

unsigned Budget::threads() const {
    return diagnostics::threads_wanted(limits_.threads);
}

void Budget::report_progress(Time now) {
    reported_ = now;
    Progress progress;
    progress.phase = phase_;
    progress.seconds = std::chrono::duration<double>(now - start_).count();
    progress.resident_bytes = run_.resident_memory();
    progress.grown_bytes =
        run_.resident_memory() > resident_at_start_ ? run_.resident_memory() - resident_at_start_ : 0;
    if (source_) source_(progress);
    limits_.progress(progress);
}

void Budget::call_after(std::chrono::duration<double> cpu_time, CallMoment moment, std::function<void()> function) {
    call_ = std::move(function);
    call_moment_ = moment;
    call_is_due_ = false;
    work_ = (work_ + 1023U) & ~std::uint64_t{1023};  // the next charge checks the time
    call_time_ = std::clock() + static_cast<std::clock_t>(cpu_time.count() * CLOCKS_PER_SEC);
}

void Budget::cancel_call() {
    call_ = {};
    call_is_due_ = false;
}

void Budget::make_call() {
    call_is_due_ = false;
    std::exchange(call_, {})();
}

void Budget::check_and_report() {
    run_.check();
    if (call_ && std::clock() >= call_time_) {
        if (call_moment_ == CallMoment::any_poll)
            make_call();
        else
            call_is_due_ = true;
    }
    const Time now = std::chrono::steady_clock::now();
    if (limits_.progress && now - reported_ >= between_reports) report_progress(now);
}

}  // namespace robochart::refine
