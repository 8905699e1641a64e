// SPDX-License-Identifier: Apache-2.0
// Runs threads that work for one caller. Exceptions of a thread are passed to the caller, and a thread that cannot be
// started counts as a reached limit. So no thread ends the program by std::terminate.
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

/// Returns the requested number of threads, or the number of cores if `requested` is 0.
[[nodiscard]] unsigned threads_wanted(unsigned requested);

/// Threads with the numbers 1, 2, ...; the caller's own thread has number 0.
class Threads {
public:
    /// Calls `work` with each number from 1 to `size` - 1, each in a separate thread. If a thread throws or cannot be
    /// started, `stop` is called, by any thread and possibly several times. If given, it must make all calls return
    /// soon. If a thread cannot be started, throws LimitReached after the others have returned.
    Threads(unsigned size, std::function<void(unsigned number)> work, std::function<void()> stop = {});
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;
    /// Stops the threads and waits for them.
    ~Threads();

    /// Returns the number of threads, including the caller's thread.
    [[nodiscard]] unsigned size() const { return static_cast<unsigned>(errors_.size()); }
    /// Waits at most this long for all threads to return. Returns true if they have returned.
    [[nodiscard]] bool returned_within(std::chrono::milliseconds);
    /// Waits until all threads have returned. If some threw, rethrows the exception of the thread with the least
    /// number.
    void join();

private:
    void run_worker(unsigned number);
    void request_stop() const;
    void join_all();

    std::function<void(unsigned)> work_;
    std::function<void()> stop_;
    std::vector<std::exception_ptr> errors_;  ///< by thread: its exception, which it writes before it returns
    std::mutex mutex_;                        ///< protects the members below
    std::condition_variable changed_;
    unsigned working_ = 0;
    std::vector<std::thread> threads_;  ///< used only by the caller
};

/// Calls `work` with each number below `count` and with the number of the executing thread. At most `threads` threads
/// are used, including the caller's. After an exception, no further call is started. When all threads have returned,
/// rethrows the exception of the call with the least number. Throws LimitReached if a thread cannot be started.
void in_parallel(std::size_t count, unsigned threads,
                 const std::function<void(std::size_t number, unsigned thread)>& work);

/// Calls `work` in `threads` threads. Meanwhile calls `watch` in the caller's thread, ten times a second and once at
/// the end. If `work` or `watch` throws, or if a thread cannot be started, calls `stop`, which must make the threads
/// return. Then passes the exception to the caller.
void in_parallel_watched(unsigned threads, const std::function<void()>& work, const std::function<void()>& stop,
                         const std::function<void()>& watch);

}  // namespace robochart::diagnostics
