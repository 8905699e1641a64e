// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/search/thread_team.hpp"

#include <cassert>
#include <chrono>

namespace robochart::refine {
namespace {

constexpr std::chrono::microseconds moment{50};

/// Waits until the value differs from `old`.
void await_change(const std::atomic<unsigned>& value, unsigned old) {
    using Clock = std::chrono::steady_clock;
    for (const Clock::time_point end = Clock::now() + moment; Clock::now() < end;)
        if (value.load(std::memory_order_acquire) != old) return;
    value.wait(old);
}

}  // namespace

ThreadTeam::ThreadTeam(unsigned size)
    : helpers_(
          size, [this](unsigned member) { serve_rounds(member); }, [this] { end(); }) {}

void ThreadTeam::end() {
    over_ = true;
    round_.fetch_add(1);
    round_.notify_all();
}

void ThreadTeam::run(const std::function<void(unsigned)>& work) {
    assert(busy_ == 0);
    work_ = &work;
    error_ = nullptr;
    busy_.store(size() - 1);
    round_.fetch_add(1);
    round_.notify_all();
    work_as(0);
    for (unsigned busy = busy_.load(); busy != 0; busy = busy_.load()) await_change(busy_, busy);
    if (error_) std::rethrow_exception(error_);
}

void ThreadTeam::work_as(unsigned member) {
    try {
        (*work_)(member);
    } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!error_) error_ = std::current_exception();
    }
}

void ThreadTeam::serve_rounds(unsigned member) {
    for (unsigned seen = 0;;) {
        await_change(round_, seen);
        ++seen;
        if (over_) return;
        work_as(member);
        if (busy_.fetch_sub(1) == 1) busy_.notify_one();
    }
}

}  // namespace robochart::refine
