// SPDX-License-Identifier: Apache-2.0
#include "base/threads/threads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <system_error>
#include <utility>

#include "base/diagnostics/budget.hpp"

namespace robochart::diagnostics {

unsigned threads_wanted(unsigned requested) {
    return requested > 0 ? requested : std::max(1U, std::thread::hardware_concurrency());
}

Threads::Threads(unsigned size, std::function<void(unsigned number)> work, std::function<void()> stop)
    : work_(std::move(work)), stop_(std::move(stop)), errors_(std::max(1U, size)) {
    threads_.reserve(this->size());
    try {
        for (unsigned number = 1; number < this->size(); ++number) {
            {
                const std::lock_guard lock(mutex_);
                ++working_;
            }
            threads_.emplace_back([this, number] { run_worker(number); });
        }
    } catch (const std::system_error& error) {
        this->request_stop();
        join_all();
        throw LimitReached(fmt::format("{} threads cannot be started: {}", size, error.what()));
    } catch (...) {
        this->request_stop();
        join_all();
        throw;
    }
}

Threads::~Threads() {
    if (threads_.empty()) return;
    request_stop();
    join_all();
}

void Threads::run_worker(unsigned number) {
    try {
        work_(number);
    } catch (...) {
        errors_[number] = std::current_exception();
        request_stop();
    }
    const std::lock_guard lock(mutex_);
    --working_;
    changed_.notify_all();
}

void Threads::request_stop() const {
    if (stop_) stop_();
}

void Threads::join_all() {
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
}

bool Threads::returned_within(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, time, [this] { return working_ == 0; });
}

void Threads::join() {
    join_all();
    for (const std::exception_ptr& error : errors_)
        if (error) std::rethrow_exception(error);
}

void in_parallel(std::size_t count, unsigned threads,
                 const std::function<void(std::size_t number, unsigned thread)>& work) {
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> failed = false;
    std::mutex mutex;
    std::size_t worst = count;
    std::exception_ptr exception;
    const auto take = [&](unsigned thread) {
        while (!failed) {
            const std::size_t number = next++;
            if (number >= count) return;
            try {
                work(number, thread);
            } catch (...) {
                const std::lock_guard lock(mutex);
                failed = true;
                if (number >= worst) continue;
                worst = number;
                exception = std::current_exception();
            }
        }
    };
    const auto team = static_cast<unsigned>(std::min<std::size_t>(std::max(1U, threads), count));
    Threads helpers(team, take, [&failed] { failed = true; });
    take(0);
    helpers.join();
    if (exception) std::rethrow_exception(exception);
}

void in_parallel_watched(unsigned threads, const std::function<void()>& work, const std::function<void()>& stop,
                         const std::function<void()>& watch) {
    constexpr std::chrono::milliseconds between_looks{100};
    Threads workers(
        threads + 1, [&work](unsigned) { work(); }, stop);
    for (bool returned = false; !returned;) {
        returned = workers.returned_within(between_looks);
        watch();
    }
    workers.join();
}

}  // namespace robochart::diagnostics
