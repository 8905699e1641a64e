// SPDX-License-Identifier: Apache-2.0
#include "app/command/run.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <new>
#include <optional>
#include <system_error>
#include <utility>

#include "app/command/command_line.hpp"
#include "app/command/output.hpp"
#include "app/command/progress.hpp"
#include "base/diagnostics/ending.hpp"
#include "base/diagnostics/files.hpp"
#include "checker/cspm/eval/evaluation_error.hpp"
#include "checker/refine/verdict/kept_search.hpp"
#include "checker/storage/storage_error.hpp"
#include "driver/settings/run_limits.hpp"

namespace robochart::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr timespec between_looks{0, 10'000'000};
/// How long work may continue after a limit, so that it can poll the limit and free memory. The short time applies if
/// the program uses far more memory than the limit.
constexpr std::chrono::milliseconds grace{300}, short_grace{100};
/// How long a verb may still print after a signal.
constexpr std::chrono::milliseconds longest_printing{2000};

}  // namespace

Run::Run(const Options& options)
    : budget_(driver::run_limits(options.limits)),
      output_(options.output),
      storage_(options.storage),
      threads_wanted_(options.limits.threads),
      recorder_(options, budget_.limits().memory_bytes),
      prints_record_(options.output.provenance && options.output.format == Format::text) {
    constexpr std::uint64_t most_cached_bytes = std::uint64_t{512} << 20U;
    if (options.cache) cache_.emplace(diagnostics::cache_folder(), diagnostics::program_identity(), most_cached_bytes);
    last_word_ = [](const std::string& why) {
        print_error("robochart-verify: {}; nothing is known yet\n", why);
        return Exit::inconclusive;
    };
    sigemptyset(&signals_taken_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) {
        struct sigaction before {};
        sigaction(signal, nullptr, &before);
        const bool unwanted = signal == SIGHUP && before.sa_handler == SIG_IGN;  // set by nohup
        if (!unwanted) sigaddset(&signals_taken_, signal);
    }
    pthread_sigmask(SIG_BLOCK, &signals_taken_, &mask_before_);
    watcher_ = std::thread([this] { watch_limits(); });
}

Run::~Run() {
    over_ = true;
    watcher_.join();
    pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
}

std::function<void(const refine::Progress&)> Run::progress(const std::string& subject) {
    return progress_of(output_, subject);
}

bool Run::continues_searches() const {
    return programs_ != nullptr || !storage_.checkpoint.empty() || !storage_.resume.empty() || !storage_.disk.empty();
}

void Run::search_by(refine::LevelStrategy& programs, const std::string& identity) {
    programs_ = &programs;
    identity_ = identity;
}

refine::LevelStrategy* Run::level_searches() {
    const std::vector<std::string> named{storage_.disk, storage_.resume, storage_.checkpoint};
    const auto folder = std::ranges::find_if(named, [](const std::string& path) { return !path.empty(); });
    if (folder == named.end()) return programs_;
    if (kept_searches_) return kept_searches_.get();
    for (const std::string& other : named)
        if (!other.empty() && other != *folder)
            throw UsageError("--checkpoint, --resume and --disk must name the same folder");
    constexpr double milliseconds = 60'000;
    refine::KeptSettings settings;
    settings.folder = *folder;
    settings.resume = !storage_.resume.empty();
    settings.disk = !storage_.disk.empty();
    settings.every = std::chrono::milliseconds(static_cast<std::int64_t>(storage_.minutes_between * milliseconds));
    settings.program = identity_.empty() ? diagnostics::program_identity() : identity_;
    settings.say = [](const std::string& what) { print_error("robochart-verify: {}\n", what); };
    refine::LevelStrategy* ranks = programs_;
    if (ranks == nullptr) {
        threads_ = std::make_unique<refine::ThreadRanks>(std::max(1U, threads_wanted_));
        ranks = threads_.get();
    }
    kept_searches_ = std::make_unique<refine::KeptSearch>(std::move(settings), *ranks);
    return kept_searches_.get();
}

void Run::end_questions() {
    if (kept_searches_) kept_searches_->all_asked();
}

void Run::last_word(LastWord word) {
    const auto lock = edit();
    last_word_ = std::move(word);
}

void Run::finish() {
    const auto lock = edit();
    finishing_ = true;
    diagnostics::program_ends = true;
}

Exit Run::end_run(const std::string& why) {
    finish();
    return last_word_(why);
}

void Run::print_record() const {
    if (!prints_record_) return;
    print_styled(wrap_lines("\n" + run_text(recorder_.record()), line_width(STDOUT_FILENO)));
}

void Run::keep_for(const std::string& path, const std::string& text) {
    const auto lock = edit();
    kept_[path] += text;
}

bool Run::write_kept_files() {
    const auto lock = edit();
    bool all = true;
    for (const auto& [path, text] : kept_) {
        const std::string error = diagnostics::replace_file(path, text, &budget_);
        if (!error.empty()) print_error("robochart-verify: {}\n", error);
        all = all && error.empty();
    }
    kept_.clear();
    return all;
}

/// Ends the run when a limit is reached. After a memory limit, the run continues if enough memory is freed, and the
/// grace period starts again whenever the used memory shrinks. A verb that is already printing its result may finish
/// after a limit, but only for `longest_printing` after a signal. If this thread cannot allocate memory, it prints a
/// fixed message and ends the program.
void Run::watch_limits() {
    bool beyond = false;
    Clock::time_point since;
    std::uint64_t lowest = 0;  // the least memory in use since the time `since`
    int asked_to_end = 0;
    const auto finishing = [this] {
        const std::unique_lock lock = try_edit();
        return lock && finishing_;
    };
    const auto look = [&] {
        if (const int signal = sigtimedwait(&signals_taken_, nullptr, &between_looks); signal > 0) {
            if (signal != SIGXCPU) asked_to_end = signal;
            handle_signal(signal);
        }
        const std::string why = budget_.reached_limit();
        if (why.empty()) {
            beyond = false;
            return;
        }
        const std::uint64_t most = budget_.limits().memory_bytes;
        const std::optional<Clock::time_point>& deadline = budget_.limits().deadline;
        const bool of_memory = !budget_.is_interrupted() && (!deadline || Clock::now() < *deadline);
        if (!of_memory) diagnostics::program_ends = true;
        if (!beyond || (of_memory && budget_.resident_memory() + most / 100 < lowest)) {
            beyond = true;
            since = Clock::now();
            lowest = budget_.resident_memory();
        }
        // When a table doubles its size, it may exceed a small limit by this much.
        constexpr std::uint64_t grown = std::uint64_t{64} << 20U;
        const bool far_beyond = budget_.resident_memory() > most + std::max(most / 4, grown);
        if (Clock::now() - since < (far_beyond ? short_grace : grace)) return;
        if (asked_to_end != 0 && Clock::now() - since >= longest_printing && finishing())
            end_at_once(128 + asked_to_end);
        say_and_end(why);
    };
    try {
        while (!over_) look();
    } catch (const std::exception&) {
        std::fputs("robochart-verify: there is no more memory\n", stderr);
        end_at_once(static_cast<int>(Exit::inconclusive));
    }
}

/// Handles a signal; a second signal ends the program at once. A program that starts this one may send a signal both to
/// it and to its process group, so two signals within a moment are treated as one. The system repeats SIGXCPU every
/// second after its CPU time limit, so this signal never ends the program at once.
void Run::handle_signal(int signal) {
    constexpr std::chrono::milliseconds moment{100};
    if (signal == SIGXCPU) return budget_.interrupt();
    if (signals_.fetch_add(1) == 0) first_signal_ = Clock::now();
    if (Clock::now() - first_signal_ > moment) end_at_once(128 + signal);
    budget_.interrupt();
}

/// Prints the partial result with the verb's LastWord and ends the program, unless the verb is about to print its
/// result.
void Run::say_and_end(const std::string& why) {
    const std::unique_lock lock = try_edit();
    if (!lock || finishing_) return;
    Exit exit = Exit::inconclusive;
    try {
        exit = last_word_(why);
        print_record();
        if (!write_kept_files()) exit = Exit::bad_input;
        finish_output();
    } catch (const OutputError& error) {
        exit = error.report_error();
    } catch (const std::bad_alloc&) {
        std::fputs("robochart-verify: there is no more memory\n", stderr);
    }
    end_at_once(static_cast<int>(exit));
}

void Run::end_at_once(int code) {
    budget_.release_resources();
    _exit(code);
}

namespace {

/// True if the system has no more threads, processes or memory.
bool is_exhausted(const std::system_error& error) {
    return error.code() == std::errc::resource_unavailable_try_again || error.code() == std::errc::not_enough_memory;
}

/// Calls the verb. If a limit ends it early, its partial result is printed (Run::end_run).
Exit run_within(Run& run, const Options& options, const std::function<Exit(const Options&)>& verb) {
    try {
        return verb(options);
    } catch (const diagnostics::LimitReached& limit) {
        return run.end_run(limit.what());
    } catch (const cspm::EvaluationError& error) {  // verbs catch this error if they know its place in the model
        run.finish();
        print_error("robochart-verify: the script cannot be evaluated: {}\n", error.what());
        return Exit::bad_input;
    } catch (const std::bad_alloc&) {
        return run.end_run("there is no more memory");
    } catch (const std::system_error& error) {
        if (!is_exhausted(error)) throw;
        return run.end_run(error.what());
    }
}

Exit run_verb(const char* program, int argc, const char* const* argv, const std::function<Exit(const Options&)>& verb) {
    const Parsed parsed = parse_command_line(argc, argv);
    if (!parsed.options) {
        if (parsed.exit == Exit::success)
            print_text(parsed.message);
        else
            print_error_text(parsed.message);
        return parsed.exit;
    }
    Options options = *parsed.options;
    // Limits do not apply to the language server, because the editor ends it.
    if (options.verb == Verb::lsp) return verb(options);
    Run run(options);
    options.run = &run;
    std::vector<std::string> command(argv + std::min(argc, 1), argv + argc);
    command.insert(command.begin(), program);
    run.recorder().set_command(std::move(command));
    try {
        const Exit exit = run_within(run, options, verb);
        run.print_record();
        return run.write_kept_files() ? exit : Exit::bad_input;
    } catch (const OutputError&) {
        (void)run.write_kept_files();
        throw;
    }
}

}  // namespace

int run_command(const char* program, int argc, const char* const* argv,
                const std::function<Exit(const Options&)>& verb) {
    allow_many_files();
    try {
        prepare_output();
        const Exit exit = run_verb(program, argc, argv, verb);
        finish_output();
        return static_cast<int>(exit);
    } catch (const OutputError& error) {
        return static_cast<int>(error.report_error());
    } catch (const storage::BadFile& error) {
        print_error("robochart-verify: {}\n", error.what());
        return static_cast<int>(Exit::bad_input);
    } catch (const UsageError& error) {
        print_error("robochart-verify: {}\ntry: robochart-verify --help\n", error.what());
        return static_cast<int>(Exit::usage);
    } catch (const std::bad_alloc&) {
        print_error_text("robochart-verify: there is no more memory\n");
        return static_cast<int>(Exit::inconclusive);
    } catch (const std::system_error& error) {
        const bool limit = is_exhausted(error);
        print_error("{}: {}{}\n", program, limit ? "" : "an internal error: ", error.what());
        return static_cast<int>(limit ? Exit::inconclusive : Exit::internal);
    } catch (const std::exception& error) {
        print_error("{}: an internal error: {}\nplease report it with the model that shows it\n", program,
                    error.what());
        return static_cast<int>(Exit::internal);
    }
}

driver::SearchContext search_context(const Options& options) {
    return {options, *options.run};
}

refine::Limits limits(const Options& options, const std::string& subject) {
    return driver::limits_of_check(search_context(options), subject);
}

/// Raises the limit of open files, but only up to a bound, because some child processes close all descriptors up to the
/// limit.
void allow_many_files() {
    constexpr rlim_t most = rlim_t{1} << 20U;
    rlimit limit{};
    if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
    const rlim_t target = std::min(limit.rlim_max, most);
    if (limit.rlim_cur >= target) return;
    limit.rlim_cur = target;
    (void)setrlimit(RLIMIT_NOFILE, &limit);
}

}  // namespace robochart::app
