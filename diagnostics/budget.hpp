// What one run may use: time, memory, and all of it only until somebody interrupts. Every phase polls the budget; what
// is reached is thrown, and said together with the phase that was at work. Here too: what must not outlive the run.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>

namespace robochart::diagnostics {

/// A limit was reached, or the run was interrupted; the message says which, and during what.
class LimitReached : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Bounds of a run. A bound that is reached gives "inconclusive", never another answer.
struct Limits {
    /// What the program and its child processes may have in main memory.
    std::uint64_t memory_bytes = 16ULL << 30U;
    std::optional<std::chrono::steady_clock::time_point> deadline;
    std::function<bool()> interrupted;  ///< polled; true ends the run
};

/// Main memory of this program; 0 where the system does not say.
[[nodiscard]] std::uint64_t resident_bytes();
/// Main memory of a process and of all that it has started.
[[nodiscard]] std::uint64_t resident_bytes_of_tree(pid_t process);

/// The limits of a run, which every long loop polls.
class Budget {
public:
    /// `phase` is what the run does while no Phase says otherwise.
    explicit Budget(Limits limits = {}, std::string phase = {});
    Budget(const Budget&) = delete;
    Budget& operator=(const Budget&) = delete;

    /// To be called in every loop whose length comes from the input; by any thread. Looks at the limits at each 16th
    /// call, and at once where they are known to be reached. Throws LimitReached.
    void poll() {
        const std::uint32_t calls = calls_.load(std::memory_order_relaxed) + 1;
        calls_.store(calls, std::memory_order_relaxed);  // calls of other threads may be lost: it is only how often
        if (stopped_.load(std::memory_order_relaxed) || (calls & 15U) == 0) check();
    }
    /// Looks now. Throws LimitReached.
    void check();
    /// Looks now: what is reached, with the phase at work; "" where all is within the limits.
    [[nodiscard]] std::string reached();
    /// From now on the run is interrupted.
    void interrupt();
    [[nodiscard]] bool interrupted() const { return interrupted_.load(std::memory_order_relaxed); }

    [[nodiscard]] const Limits& limits() const { return limits_; }
    /// Program and children, as last looked at.
    [[nodiscard]] std::uint64_t resident() const { return resident_.load(std::memory_order_relaxed); }

    /// While it lives, the run is doing this: "reading the model". They nest; the innermost is said.
    class Phase {
    public:
        Phase(Budget& budget, std::string what);
        ~Phase();
        Phase(const Phase&) = delete;
        Phase& operator=(const Phase&) = delete;

    private:
        Budget& budget_;
        std::string before_;
    };

    /// While it lives, a temporary file or folder, or a process group that the run has started, is known to the
    /// budget: `release` ends and removes it where the run cannot be left in order.
    class Held {
    public:
        Held(Budget* budget, std::string path);
        Held(Budget* budget, pid_t group);
        ~Held();
        Held(const Held&) = delete;
        Held& operator=(const Held&) = delete;

    private:
        Budget* budget_;
        std::string path_;
        pid_t group_ = 0;
    };
    /// Ends all process groups and removes all files and folders that are held. For the end of the program only.
    void release();

private:
    using Time = std::chrono::steady_clock::time_point;

    [[nodiscard]] bool memory_exceeded(Time now);
    [[nodiscard]] std::string while_what() const;

    const Limits limits_;
    std::atomic<std::uint32_t> calls_{0};
    std::atomic<bool> stopped_{false};
    std::atomic<bool> interrupted_{false};
    std::atomic<std::int64_t> memory_checked_;  ///< ticks of the clock
    std::atomic<std::uint64_t> resident_{0};
    mutable std::mutex mutex_;  ///< of what follows
    std::string phase_;
    std::multiset<std::string> paths_;
    std::multiset<pid_t> groups_;
};

}  // namespace robochart::diagnostics
