// SPDX-License-Identifier: Apache-2.0
// A team of threads that repeatedly execute a task together. Between two tasks the threads first poll for a moment,
// because waking a thread takes longer, and then sleep.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>

#include "base/threads/threads.hpp"

namespace robochart::refine {

class ThreadTeam {
public:
    /// `size` includes the caller's thread. Throws LimitReached if a thread cannot be started.
    explicit ThreadTeam(unsigned size);
    ThreadTeam(const ThreadTeam&) = delete;
    ThreadTeam& operator=(const ThreadTeam&) = delete;

    [[nodiscard]] unsigned size() const { return helpers_.size(); }
    /// Calls `work` with the number of every member; the caller itself is number 0. Returns when all members have
    /// returned. All members then see the earlier writes of the other members. Throws the exception of the first member
    /// that throws.
    void run(const std::function<void(unsigned member)>& work);

private:
    void serve_rounds(unsigned member);
    void work_as(unsigned member);
    void end();

    const std::function<void(unsigned)>* work_ = nullptr;
    std::atomic<unsigned> round_ = 0;
    std::atomic<unsigned> busy_ = 0;
    std::atomic<bool> over_ = false;
    std::mutex mutex_;
    std::exception_ptr error_;  ///< the first exception of this round; guarded by mutex_
    diagnostics::Threads helpers_;
};

}  // namespace robochart::refine
