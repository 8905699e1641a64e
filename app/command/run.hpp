// One run of the command: its budget, and a thread that watches over it. The thread takes SIGINT, SIGTERM, SIGHUP and
// SIGXCPU, and looks at the limits all the time. What is reached, every phase finds out by polling the budget, and the
// verb ends in order. Should some work not poll for too long, the thread itself prints what is known and ends the
// program: a limit does not depend on whoever should have polled. A second signal ends the program at once.
#pragma once

#include <signal.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>

#include "app/command/options.hpp"
#include "diagnostics/budget.hpp"
#include "diagnostics/cache/cache.hpp"

namespace robochart::refine {
class LevelStrategy;
}

namespace robochart::app {

class Run {
public:
    /// The limits begin now. Threads that are to be spared the signals are started after.
    explicit Run(const Options&);
    ~Run();
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

    [[nodiscard]] diagnostics::Budget& budget() { return budget_; }
    /// What earlier runs have worked out; null where it is not wanted.
    [[nodiscard]] diagnostics::Cache* cache() { return cache_ ? &*cache_ : nullptr; }
    /// How searches are kept in files, as these options say; null where that is not wanted. Throws UsageError,
    /// storage::BadFile or storage::CannotWrite where it cannot be. The same for all calls.
    [[nodiscard]] refine::LevelStrategy* kept_searches(const Options&);
    /// The verb has asked all its questions: what was kept of their searches is removed if all are decided.
    void all_asked();
    /// A signal has come.
    [[nodiscard]] bool interrupted() const { return signals_.load() > 0; }

    /// Prints what is known of the verb's answer, where `why` nothing more can be; returns the exit code.
    using LastWord = std::function<Exit(const std::string& why)>;
    /// From now on this is the last word. It may be called by the watching thread, while `edit` is not held, and must
    /// not look at anything else that is being changed.
    void last_word(LastWord);
    /// To be held while what the last word shows is changed. A thread may hold it several times.
    [[nodiscard]] std::unique_lock<std::recursive_mutex> edit() { return std::unique_lock(mutex_); }
    /// The verb has its answer, or knows that it will get none, and prints: limits no longer cut it short.
    void finish();
    /// Whether this run has not yet written a file of this path below `--out`; from now on it has.
    [[nodiscard]] bool claim(const std::string& path) { return written_.insert(path).second; }
    /// The last word, said by the verb's own thread.
    Exit stopped(const std::string& why);
    /// Whether it is the watching thread that asks: then what the verb's thread works on cannot be looked at.
    [[nodiscard]] bool is_watching() const { return std::this_thread::get_id() == watcher_.get_id(); }

    /// Adds to what the file of this path gets when the run ends, in whatever way.
    void keep_for(const std::string& path, const std::string& text);
    /// Writes these files. False, with a message, if one cannot be written.
    [[nodiscard]] bool write_kept();

private:
    void watch();
    void take(int signal);
    void say_and_end(const std::string& why);
    [[noreturn]] void end_at_once(int code);

    diagnostics::Budget budget_;
    std::optional<diagnostics::Cache> cache_;
    std::unique_ptr<refine::LevelStrategy> threads_, kept_searches_;  ///< the latter's searches are by the former
    sigset_t signals_taken_{};
    sigset_t mask_before_{};
    std::atomic<int> signals_{0};
    std::chrono::steady_clock::time_point first_signal_;  ///< of the watching thread
    std::atomic<bool> over_{false};
    std::recursive_mutex mutex_;
    bool finishing_ = false;  ///< under mutex_
    LastWord last_word_;      ///< under mutex_
    std::set<std::string> written_;
    std::map<std::string, std::string> kept_;  ///< texts by path; under mutex_
    std::thread watcher_;
};

/// A program's whole life: reads the command line, runs the verb within its limits, and sees to it that what could not
/// be written, or decided, is said. Returns the exit code.
int run_command(const char* program, int argc, const char* const* argv,
                const std::function<Exit(const Options&)>& verb);

/// This program may have as many files open as the system lets it: searches that are kept in files have some at each
/// thread. To be called at the start of a program that does not call run_command.
void allow_many_files();

/// 16 GiB, or three quarters of the memory that this machine or its control group has if that is less.
[[nodiscard]] std::uint64_t default_memory();

}  // namespace robochart::app
