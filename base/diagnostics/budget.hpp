// SPDX-License-Identifier: Apache-2.0
// Limits the time and the memory of one run, which may also be interrupted. Every phase polls the budget. When a limit
// is reached, an exception names the limit and the active phase. The budget also records files and processes that must
// be removed when the run ends.
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

#include "base/diagnostics/pollable.hpp"

namespace robochart::diagnostics {

/// Thrown if a limit was reached or the run was interrupted. The message names the limit and the phase.
class LimitReached : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The limits of a run. If a limit is reached, the answer is "inconclusive", never another answer.
struct Limits {
    /// The main memory that the program and its child processes may use.
    std::uint64_t memory_bytes = 16ULL << 30U;
    std::optional<std::chrono::steady_clock::time_point> deadline;
    std::function<bool()> interrupted;  ///< whether the run is to end; it is polled
};

/// Returns the main memory in bytes that this program uses, or 0 if the system does not report it.
[[nodiscard]] std::uint64_t resident_bytes();
/// Returns the main memory in bytes that a process and all its descendants use.
[[nodiscard]] std::uint64_t resident_bytes_of_tree(pid_t process);

/// Checks the limits of a run. Every long loop polls it.
class Budget final : public Pollable {
public:
    /// `phase`: what the run does while no Phase is active.
    explicit Budget(Limits limits = {}, std::string phase = {});
    Budget(const Budget&) = delete;
    Budget& operator=(const Budget&) = delete;

    /// Every loop whose length depends on the input must call this function. Any thread may call it. It checks the
    /// limits in every 16th call, and in all calls after a limit was reached. Throws LimitReached.
    void poll() override {
        const std::uint32_t calls = calls_.load(std::memory_order_relaxed) + 1;
        // A call of another thread at the same time may not be counted. The only effect is that the limits are checked
        // less often.
        calls_.store(calls, std::memory_order_relaxed);
        if (stopped_.load(std::memory_order_relaxed) || (calls & 15U) == 0) check();
    }
    /// Checks the limits immediately. Throws LimitReached.
    void check();
    /// Checks the limits immediately. Returns the limit that is reached, with the active phase, or "" if none is
    /// reached.
    [[nodiscard]] std::string reached_limit();
    /// Interrupts the run.
    void interrupt();
    [[nodiscard]] bool is_interrupted() const { return interrupted_.load(std::memory_order_relaxed); }

    [[nodiscard]] const Limits& limits() const { return limits_; }
    /// Returns the memory of the program and its child processes, as last measured.
    [[nodiscard]] std::uint64_t resident_memory() const { return resident_.load(std::memory_order_relaxed); }

    /// Names what the run does during the lifetime of this object, such as "reading the model". Phases may be nested;
    /// messages name the innermost phase.
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

    /// While it exists, a temporary file, a temporary folder or a process group is registered. If the run cannot end
    /// normally, `release_resources` removes the file or folder, or ends the processes.
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
    /// Ends all registered process groups and removes all registered files and folders. It may be called only at the
    /// end of the program.
    void release_resources();

private:
    using Time = std::chrono::steady_clock::time_point;

    [[nodiscard]] bool memory_exceeded(Time now);
    [[nodiscard]] std::string while_what() const;

    const Limits limits_;
    std::atomic<std::uint32_t> calls_{0};
    std::atomic<bool> stopped_{false};
    std::atomic<bool> interrupted_{false};
    std::atomic<std::int64_t> memory_checked_;  ///< in clock ticks
    std::atomic<std::uint64_t> resident_{0};
    mutable std::mutex mutex_;  ///< protects the members below
    std::string phase_;
    std::multiset<std::string> paths_;
    std::multiset<pid_t> groups_;
};

/// Returns the budget, or `unlimited` if the pointer is null.
[[nodiscard]] inline Pollable& or_unlimited(Budget* budget) {
    if (budget == nullptr) return unlimited;
    return *budget;
}

}  // namespace robochart::diagnostics
