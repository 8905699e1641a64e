// SPDX-License-Identifier: Apache-2.0
// The resources of one run: time and memory. The run may also be interrupted. Every phase polls the budget. When a
// limit is reached, an exception names it and the active phase. The budget also records files and processes that must
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

/// A limit was reached or the run was interrupted; the message names the limit and the phase.
class LimitReached : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The limits of a run. A limit that is reached gives "inconclusive", never another answer.
struct Limits {
    /// The main memory that the program and its child processes may use.
    std::uint64_t memory_bytes = 16ULL << 30U;
    std::optional<std::chrono::steady_clock::time_point> deadline;
    std::function<bool()> interrupted;  ///< polled; true ends the run
};

/// The main memory of this program in bytes; 0 if the system does not report it.
[[nodiscard]] std::uint64_t resident_bytes();
/// The main memory in bytes of a process and of all its descendants.
[[nodiscard]] std::uint64_t resident_bytes_of_tree(pid_t process);

/// The limits of a run, which every long loop polls.
class Budget final : public Pollable {
public:
    /// `phase`: the activity of the run while no Phase is active.
    explicit Budget(Limits limits = {}, std::string phase = {});
    Budget(const Budget&) = delete;
    Budget& operator=(const Budget&) = delete;

    /// Must be called in every loop whose length depends on the input; any thread may call it. Checks the limits in
    /// every 16th call, and in every call after a limit was reached. Throws LimitReached.
    void poll() override {
        const std::uint32_t calls = calls_.load(std::memory_order_relaxed) + 1;
        calls_.store(calls, std::memory_order_relaxed);  // a call of another thread may not be counted; then the limits
                                                         // are checked less often
        if (stopped_.load(std::memory_order_relaxed) || (calls & 15U) == 0) check();
    }
    /// Checks the limits now. Throws LimitReached.
    void check();
    /// Checks the limits now. Returns the limit that is reached, with the active phase; "" if none is.
    [[nodiscard]] std::string reached_limit();
    /// Interrupts the run.
    void interrupt();
    [[nodiscard]] bool is_interrupted() const { return interrupted_.load(std::memory_order_relaxed); }

    [[nodiscard]] const Limits& limits() const { return limits_; }
    /// The memory of the program and its children, as last measured.
    [[nodiscard]] std::uint64_t resident_memory() const { return resident_.load(std::memory_order_relaxed); }

    /// Names the activity of the run while the object exists, such as "reading the model". Phases may be nested;
    /// messages name the innermost one.
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

    /// Registers a temporary file or folder, or a process group started by the run, while the object exists.
    /// `release_resources` removes or ends it if the run cannot end normally.
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
    /// Ends all registered process groups and removes all registered files and folders. Must be called only at the end
    /// of the program.
    void release_resources();

private:
    using Time = std::chrono::steady_clock::time_point;

    [[nodiscard]] bool memory_exceeded(Time now);
    [[nodiscard]] std::string while_what() const;

    const Limits limits_;
    std::atomic<std::uint32_t> calls_{0};
    std::atomic<bool> stopped_{false};
    std::atomic<bool> interrupted_{false};
    std::atomic<std::int64_t> memory_checked_;  ///< clock ticks
    std::atomic<std::uint64_t> resident_{0};
    mutable std::mutex mutex_;  ///< protects the members below
    std::string phase_;
    std::multiset<std::string> paths_;
    std::multiset<pid_t> groups_;
};

/// The budget, or `unlimited` if the pointer is null.
[[nodiscard]] inline Pollable& or_unlimited(Budget* budget) {
    if (budget == nullptr) return unlimited;
    return *budget;
}

}  // namespace robochart::diagnostics
