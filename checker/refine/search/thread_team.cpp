#include "checker/refine/search/thread_team.hpp"

#include <fmt/format.h>

#include <chrono>
#include <system_error>

#include "diagnostics/budget.hpp"

namespace robochart::refine {
namespace {

constexpr std::chrono::microseconds moment{50};

/// Returns when the value is another one.
void await_change(const std::atomic<unsigned>& value, unsigned old) {
    using Clock = std::chrono::steady_clock;
    for (const Clock::time_point end = Clock::now() + moment; Clock::now() < end;)
        if (value.load(std::memory_order_acquire) != old) return;
    value.wait(old);
}

}  // namespace

void start_threads(std::vector<std::thread>& threads, unsigned size, const std::function<void(unsigned)>& work) {
    threads.reserve(size);
    try {
        for (unsigned number = 1; number < size; ++number) threads.emplace_back(work, number);
    } catch (const std::system_error& error) {
        throw diagnostics::LimitReached(fmt::format("{} threads cannot be started: {}", size, error.what()));
    }
}

ThreadTeam::ThreadTeam(unsigned size) {
    try {
        start_threads(helpers_, size, [this](unsigned member) { help(member); });
    } catch (...) {
        end();
        throw;
    }
}

ThreadTeam::~ThreadTeam() {
    end();
}

void ThreadTeam::end() {
    over_ = true;
    round_.fetch_add(1);
    round_.notify_all();
    for (std::thread& helper : helpers_) helper.join();
}

void ThreadTeam::run(const std::function<void(unsigned)>& work) {
    work_ = &work;
    busy_.store(static_cast<unsigned>(helpers_.size()));
    round_.fetch_add(1);
    round_.notify_all();
    work(0);
    for (unsigned busy = busy_.load(); busy != 0; busy = busy_.load()) await_change(busy_, busy);
}

void ThreadTeam::help(unsigned member) {
    for (unsigned seen = 0;;) {
        await_change(round_, seen);
        ++seen;
        if (over_) return;
        (*work_)(member);
        if (busy_.fetch_sub(1) == 1) busy_.notify_one();
    }
}

}  // namespace robochart::refine
