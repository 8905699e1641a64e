// SPDX-License-Identifier: Apache-2.0
// Defines one run of the command: its budget, and a thread that watches the run. The thread receives SIGINT, SIGTERM,
// SIGHUP and SIGXCPU, and checks the limits continuously. A phase notices a limit when it polls the budget, and the
// verb then ends normally. If no phase polls for too long, the watching thread itself prints the known results and ends
// the program. So limits do not depend on polling. A second signal ends the program at once.
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
#include "app/command/run_record.hpp"
#include "base/cache/cache.hpp"
#include "base/diagnostics/budget.hpp"
#include "driver/settings/services.hpp"

namespace robochart::refine {
class LevelStrategy;
}

namespace robochart::app {

class Run final : public driver::Services {
public:
    /// Starts the time limit. Blocks the signals in this thread and in threads that it starts later.
    explicit Run(const Options&);
    ~Run() override;
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

    [[nodiscard]] diagnostics::Budget& budget() override { return budget_; }
    [[nodiscard]] diagnostics::Cache* cache() override { return cache_ ? &*cache_ : nullptr; }
    [[nodiscard]] std::function<void(const refine::Progress&)> progress(const std::string& subject) override;
    [[nodiscard]] bool continues_searches() const override;
    /// Returns the strategy for searches in files. Throws UsageError, storage::BadFile or storage::CannotWrite if the
    /// files cannot be used.
    [[nodiscard]] refine::LevelStrategy* level_searches() override;
    /// Collects the record of this run, which every report contains.
    [[nodiscard]] RunRecorder& recorder() { return recorder_; }
    /// Selects searches by several programs (app/mpi). Programs with equal `identity` can share checkpoints. Must be
    /// called before the first search.
    void search_by(refine::LevelStrategy& programs, const std::string& identity);
    /// Must be called when the verb has registered all its assertions. If all of them are decided, removes the files of
    /// their searches.
    void end_questions();
    /// True if a signal was received.
    [[nodiscard]] bool is_interrupted() const { return signals_.load() > 0; }

    /// A function that prints the known part of the verb's result when the run must end early, and returns the exit
    /// code. `why` is the reason.
    using LastWord = std::function<Exit(const std::string& why)>;
    /// Sets the function that prints the partial result. The watching thread may call it while no thread holds the lock
    /// edit(), so it must only read data that is changed under this lock.
    void last_word(LastWord);
    /// Must be called before the verb prints its final result, or when it is known that the verb has no result. From
    /// then on, limits do not interrupt the verb.
    void finish();
    /// Registers the path of a file below `--out`. Returns true if this run has not yet written a file with this path.
    [[nodiscard]] bool claim_path(const std::string& path) { return written_.insert(path).second; }
    /// Prints the partial result from the verb's own thread; returns the exit code.
    Exit end_run(const std::string& why);
    /// True if the caller is the watching thread, which must not access data of the verb's thread.
    [[nodiscard]] bool is_watching() const { return std::this_thread::get_id() == watcher_.get_id(); }

    /// Prints the record of the run below a text report, if --provenance is given.
    void print_record() const;

    /// Appends to the text of the file with this path. The file is written when the run ends, even if it ends early.
    void keep_for(const std::string& path, const std::string& text);
    /// Writes the files of keep_for. Prints a message and returns false if one cannot be written.
    [[nodiscard]] bool write_kept_files();

private:
    void watch_limits();
    void handle_signal(int signal);
    void say_and_end(const std::string& why);
    [[noreturn]] void end_at_once(int code);

    diagnostics::Budget budget_;
    OutputOptions output_;
    StorageOptions storage_;
    unsigned threads_wanted_;  ///< threads of a search in files
    refine::LevelStrategy* programs_ = nullptr;
    std::string identity_;  ///< if "", the identity of this program
    RunRecorder recorder_;
    const bool prints_record_;
    std::optional<diagnostics::Cache> cache_;
    std::unique_ptr<refine::LevelStrategy> threads_, kept_searches_;  ///< kept_searches_ uses threads_
    sigset_t signals_taken_{};
    sigset_t mask_before_{};
    std::atomic<int> signals_{0};
    std::chrono::steady_clock::time_point first_signal_;  ///< used only by the watching thread
    std::atomic<bool> over_{false};
    bool finishing_ = false;  ///< protected by edit()
    LastWord last_word_;      ///< protected by edit()
    std::set<std::string> written_;
    std::map<std::string, std::string> kept_;  ///< texts by path; protected by edit()
    std::thread watcher_;
};

/// Returns the context of searches with these options and their run.
[[nodiscard]] driver::SearchContext search_context(const Options&);
/// Returns the limits of one check. Progress is reported as the options require, under the name `subject`.
[[nodiscard]] refine::Limits limits(const Options&, const std::string& subject = "");

/// Runs the whole program: parses the command line, runs the verb within its limits, and reports what could not be
/// written or decided. Returns the exit code.
int run_command(const char* program, int argc, const char* const* argv,
                const std::function<Exit(const Options&)>& verb);

/// Raises the limit of open files, because searches in files open several files per thread. Must be called at the start
/// of a program that does not call run_command.
void allow_many_files();

}  // namespace robochart::app
