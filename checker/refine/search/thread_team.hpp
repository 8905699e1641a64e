// SPDX-License-Identifier: Apache-2.0
// A team of threads that repeatedly execute a task together. Between two tasks, a thread first polls for a moment and
// only then sleeps, because waking a sleeping thread takes time.
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
    /// Calls `work` in every member with its number; the caller is number 0. Returns when all members have finished.
    /// All members then see what the other members have written. Throws the exception of the first member that throws.
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
    std::exception_ptr error_;  ///< the first exception of the current task; guarded by mutex_
    diagnostics::Threads helpers_;
};

}  // namespace robochart::refine
