// Threads that do one piece of work together, again and again. In between they look out for the next one for a moment,
// since being woken takes longer, then sleep.
#pragma once

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace robochart::refine {

/// Starts threads that do `work`, with the numbers 1, 2, ... below `size`, and adds them to `threads`, which is empty.
/// Throws LimitReached where one cannot be started; those before it are then in `threads`, for the caller to end.
void start_threads(std::vector<std::thread>& threads, unsigned size, const std::function<void(unsigned)>& work);

class ThreadTeam {
public:
    /// `size` counts the caller's thread too. Throws LimitReached where a thread cannot be started.
    explicit ThreadTeam(unsigned size);
    ThreadTeam(const ThreadTeam&) = delete;
    ThreadTeam& operator=(const ThreadTeam&) = delete;
    ~ThreadTeam();

    [[nodiscard]] unsigned size() const { return static_cast<unsigned>(helpers_.size()) + 1; }
    /// Calls `work` with every member's number, 0 by the caller itself, and returns when all have come back. What one
    /// member has written before is seen by all after. `work` throws nothing.
    void run(const std::function<void(unsigned member)>& work);

private:
    void help(unsigned member);
    void end();

    const std::function<void(unsigned)>* work_ = nullptr;
    std::atomic<unsigned> round_ = 0;
    std::atomic<unsigned> busy_ = 0;
    bool over_ = false;
    std::vector<std::thread> helpers_;
};

}  // namespace robochart::refine
