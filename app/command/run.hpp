// SPDX-License-Identifier: Apache-2.0
// One run of the command: its budget, and a thread that watches it. The thread receives SIGINT, SIGTERM, SIGHUP and
// SIGXCPU, and checks the limits continuously. A phase notices a limit when it polls the budget, and the verb then ends
// normally. If some work does not poll for too long, the thread itself prints the known results and ends the program,
// so limits do not depend on polling. A second signal ends the program at once.
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
    /// The limits start now. Threads that must not receive the signals must be started later.
    explicit Run(const Options&);
    ~Run() override;
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

    [[nodiscard]] diagnostics::Budget& budget() override { return budget_; }
    [[nodiscard]] diagnostics::Cache* cache() override { return cache_ ? &*cache_ : nullptr; }
    [[nodiscard]] std::function<void(const refine::Progress&)> progress(const std::string& subject) override;
    [[nodiscard]] bool continues_searches() const override;
    /// Throws UsageError, storage::BadFile or storage::CannotWrite if the files cannot be used.
    [[nodiscard]] refine::LevelStrategy* level_searches() override;
    /// Collects what every report says about this run.
    [[nodiscard]] RunRecorder& recorder() { return recorder_; }
    /// Searches are done by several programs (app/mpi). `identity`: of programs that can share checkpoints. Must be
    /// called before the first search.
    void search_by(refine::LevelStrategy& programs, const std::string& identity);
    /// Must be called when the verb has registered all its assertions. The files of their searches are removed if all
    /// are decided.
    void end_questions();
    /// True if a signal was received.
    [[nodiscard]] bool is_interrupted() const { return signals_.load() > 0; }

    /// Prints the known part of the verb's answer when the run must end because of `why`; returns the exit code.
    using LastWord = std::function<Exit(const std::string& why)>;
    /// Sets the last word. The watching thread may call it while no thread holds `edit`. It must not access other data
    /// that is being changed.
    void last_word(LastWord);
    /// Must be called when the verb has its answer, or will get none, and prints it. From then on, limits do not
    /// interrupt it.
    void finish();
    /// Registers the path of a file below `--out`. True if this run has not yet written a file with this path.
    [[nodiscard]] bool claim_path(const std::string& path) { return written_.insert(path).second; }
    /// The last word, called by the verb's own thread.
    Exit end_run(const std::string& why);
    /// True if the watching thread calls this; data of the verb's thread must not be accessed then.
    [[nodiscard]] bool is_watching() const { return std::this_thread::get_id() == watcher_.get_id(); }

    /// Prints the record of the run below a text report, if --provenance is given.
    void print_record() const;

    /// Appends to a text that is written to the file with this path when the run ends, even if it ends early.
    void keep_for(const std::string& path, const std::string& text);
    /// Writes these files. Returns false, with a message, if one cannot be written.
    [[nodiscard]] bool write_kept_files();

private:
    void watch_limits();
    void handle_signal(int signal);
    void say_and_end(const std::string& why);
    [[noreturn]] void end_at_once(int code);

    diagnostics::Budget budget_;
    OutputOptions output_;
    StorageOptions storage_;
    unsigned threads_wanted_;  ///< of a search in files
    refine::LevelStrategy* programs_ = nullptr;
    std::string identity_;  ///< "": the program's own
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

/// What searches need: these options, and their run.
[[nodiscard]] driver::SearchContext search_context(const Options&);
/// The limits of one check. Progress is reported as the options require, under the name `subject`.
[[nodiscard]] refine::Limits limits(const Options&, const std::string& subject = "");

/// The whole program: parses the command line, runs the verb within its limits, and reports anything that could not be
/// written or decided. Returns the exit code.
int run_command(const char* program, int argc, const char* const* argv,
                const std::function<Exit(const Options&)>& verb);

/// Raises the number of open files to the system's limit, because searches in files open several per thread. Must be
/// called at the start of a program that does not call run_command.
void allow_many_files();

}  // namespace robochart::app
