// Threads that work for one caller. What a thread throws reaches the caller, and a thread that cannot be started is a
// limit like any other: no thread of the program ends it by std::terminate.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace robochart::diagnostics {

/// As many threads as asked for; 0: one a core.
[[nodiscard]] unsigned threads_wanted(unsigned asked);

/// Threads with the numbers 1, 2, ...; the caller's own thread is number 0.
class Threads {
public:
    /// Calls `work` with each number from 1 to `size` - 1 in a thread of its own. `stop`, if there is one, makes all of
    /// them return soon; it is called, by any thread and perhaps several times, where one throws or cannot be started.
    /// Throws LimitReached where one cannot be started, after the others have returned.
    Threads(unsigned size, std::function<void(unsigned number)> work, std::function<void()> stop = {});
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;
    /// Stops them and waits for them.
    ~Threads();

    /// With the caller's.
    [[nodiscard]] unsigned size() const { return static_cast<unsigned>(errors_.size()); }
    /// Waits until all have returned, at most so long. Whether they have.
    [[nodiscard]] bool returned_within(std::chrono::milliseconds);
    /// Waits until all have returned; throws what the one with the least number has thrown.
    void join();

private:
    void be(unsigned number);
    void stop() const;
    void join_all();

    std::function<void(unsigned)> work_;
    std::function<void()> stop_;
    std::vector<std::exception_ptr> errors_;  ///< by number; written by its thread before it returns
    std::mutex mutex_;                        ///< of what follows
    std::condition_variable changed_;
    unsigned working_ = 0;
    std::vector<std::thread> threads_;  ///< of the caller alone
};

/// Calls `work` with each number below `count` and with the number of the thread that does it, by at most so many
/// threads, the caller's among them. After an exception no further number is begun; the exception of the least number
/// that has one is thrown when all have returned. Throws LimitReached where a thread cannot be started.
void in_parallel(std::size_t count, unsigned threads,
                 const std::function<void(std::size_t number, unsigned thread)>& work);

/// Calls `work` in so many threads, and `watch` meanwhile in the caller's, ten times a second and once at the end. If
/// one of these throws, or a thread cannot be started, `stop` makes the threads return, and the exception is thrown
/// when they have.
void in_parallel_watched(unsigned threads, const std::function<void()>& work, const std::function<void()>& stop,
                         const std::function<void()>& watch);

}  // namespace robochart::diagnostics
