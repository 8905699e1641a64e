// Threads that do one piece of work together, again and again. In between they look out for the next one for a moment,
// since being woken takes longer, then sleep.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>

#include "diagnostics/threads/threads.hpp"

namespace robochart::refine {

class ThreadTeam {
public:
    /// `size` counts the caller's thread too. Throws LimitReached where a thread cannot be started.
    explicit ThreadTeam(unsigned size);
    ThreadTeam(const ThreadTeam&) = delete;
    ThreadTeam& operator=(const ThreadTeam&) = delete;

    [[nodiscard]] unsigned size() const { return helpers_.size(); }
    /// Calls `work` with every member's number, 0 by the caller itself, and returns when all have come back. What one
    /// member has written before is seen by all after. Throws what the first member that throws has thrown.
    void run(const std::function<void(unsigned member)>& work);

private:
    void help(unsigned member);
    void work_as(unsigned member);
    void end();

    const std::function<void(unsigned)>* work_ = nullptr;
    std::atomic<unsigned> round_ = 0;
    std::atomic<unsigned> busy_ = 0;
    std::atomic<bool> over_ = false;
    std::mutex mutex_;
    std::exception_ptr error_;  ///< of this round; under mutex_
    diagnostics::Threads helpers_;
};

}  // namespace robochart::refine
