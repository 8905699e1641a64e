// SPDX-License-Identifier: Apache-2.0
// robochart-replay: runs the table of a conformance certificate again (docs/certificates.md, "Replaying a table").
//
// The program trusts the compiler, the C interface of the code (explore_abi.h), SHA-256, and that `step` has no memory
// outside the state: it runs each row once. It shares no code with the check of conformance: only the C interface, and
// functions that write files, run the compiler and compute digests. The code runs in another process with limits, so a
// crash of the code is an answer. The limits do not protect against code that was written to attack: a certificate
// contains code, which this program compiles and runs.
#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>
#include <optional>
#include <sstream>
#include <thread>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/files.hpp"
#include "base/diagnostics/programs.hpp"
#include "conformance/replay/rows.hpp"

namespace robochart::replay {

namespace {

namespace fs = std::filesystem;

/// The exit codes, as for robochart-verify.
enum Exit { replayed = 0, differs = 1, unusable = 2, not_run = 3, wrong_use = 4 };

constexpr const char* usage =
    "usage: robochart-replay [--object FILE] [--row-timeout SECONDS] CERTIFICATE\n"
    "Builds the code in a certificate of `robochart-verify conform --certify`, and runs each row of its table once.\n"
    "With --object, runs the table against this shared object instead. A row may take 20 seconds, or --row-timeout.\n"
    "Exit code 0: the code does what the table states; 1: it does something else; 2: the certificate or the object\n"
    "cannot be used; 3: the code could not be built or run to the end; 4: wrong use.\n";

constexpr std::uint64_t most_memory = std::uint64_t{4} << 30U;
constexpr std::size_t longest_answer = 4000;  // fits into a pipe

/// Whether this program is built with AddressSanitizer, which reserves more addresses than the limit of memory.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool reserves_addresses = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool reserves_addresses = true;
#else
constexpr bool reserves_addresses = false;
#endif
#else
constexpr bool reserves_addresses = false;
#endif

struct Options {
    std::string certificate;
    std::string object;            ///< "": built from the certificate
    std::chrono::seconds row{20};  ///< a row that takes longer does not end
};

/// Thrown if the code could not be built or run to the end.
class NotRun : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The answer of the process that runs the code.
struct Answer {
    Exit exit = unusable;
    std::string words;
};

/// Copies the sources to the folder `work`, so that only they are compiled, and builds the object there.
std::string build_object(const Table& table, const std::string& work) {
    const std::string sources = work + "/code";
    std::string error;
    for (const Source& source : table.sources) {
        error = diagnostics::write_below(sources, source.path, source.text);
        if (!error.empty()) throw NotRun(error);
    }
    const std::string object = work + "/object.so";
    std::vector<std::string> command = table.build;
    for (std::string& word : command)
        if (word == "OBJECT") word = object;
    if (command.empty()) throw Unusable("code.txt: the command that builds the code is missing");
    const std::string log = work + "/log";
    fs::current_path(sources);
    const int status = diagnostics::run_program(command, log, error);
    if (status < 0) throw NotRun(fmt::format("the code could not be built: {}", error));
    std::ifstream in(log, std::ios::binary);
    std::ostringstream output;
    output << in.rdbuf();
    if (status > 0)
        throw NotRun(fmt::format("the code could not be built, {} failed with status {}:\n{}", command.front(), status,
                                 output.str()));
    return object;
}

void limit_process() {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const auto limit = [](auto resource, std::uint64_t most) {
        const struct rlimit both = {most, most};
        setrlimit(resource, &both);
    };
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    if (!reserves_addresses) limit(RLIMIT_AS, most_memory);
    const int nothing = open("/dev/null", O_RDWR);
    for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nothing, file);
}

/// Loads the object and runs the rows, in the process with limits.
Answer run_rows(const Table& table, const std::string& object, Progress& progress) {
    try {
        void* const library = dlopen(object.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (library == nullptr) return {unusable, fmt::format("the object cannot be loaded: {}", dlerror())};
        void* const symbol = dlsym(library, "robochart_explore");
        if (symbol == nullptr) return {unusable, "the object does not have the symbol robochart_explore"};
        const rc_interface* const code = reinterpret_cast<const rc_interface* (*)()>(symbol)();
        if (code == nullptr) return {unusable, "the object has no interface"};
        const auto difference = first_difference(table, *code, progress);
        return difference ? Answer{differs, *difference} : Answer{replayed, ""};
    } catch (const Unusable& reason) {
        return {unusable, reason.what()};
    } catch (const std::bad_alloc&) {
        return {not_run, "there is no more memory"};
    }
}

/// Memory that this process shares with its child.
class SharedMemory {
public:
    explicit SharedMemory(std::size_t bytes)
        : bytes_(bytes), at_(mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
        if (at_ == MAP_FAILED) throw std::bad_alloc();
    }
    ~SharedMemory() { munmap(at_, bytes_); }
    SharedMemory(const SharedMemory&) = delete;
    SharedMemory& operator=(const SharedMemory&) = delete;
    [[nodiscard]] char* at() const { return static_cast<char*>(at_); }

private:
    std::size_t bytes_;
    void* at_;
};

/// Waits until the child ends, or kills it when a row takes too long. Returns its status; no value if it was killed.
std::optional<int> wait_for(pid_t child, const Progress& progress, std::chrono::seconds longest_row) {
    using Clock = std::chrono::steady_clock;
    std::uint64_t seen = progress.rows;
    Clock::time_point since = Clock::now();
    int status = 0;
    while (waitpid(child, &status, WNOHANG) == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        if (const std::uint64_t now = progress.rows; now != seen) {
            seen = now;
            since = Clock::now();
        }
        if (Clock::now() - since < longest_row) continue;
        kill(child, SIGKILL);
        waitpid(child, &status, 0);
        return std::nullopt;
    }
    return status;
}

/// Returns the answer if the child gave none: the code ended the process, or did not end its row.
Answer answer_of_failure(const Table& table, const Progress& progress, std::optional<int> status) {
    std::string what = "the code ends the process";
    if (!status) what = "the code does not return";
    if (status && WIFSIGNALED(*status))
        what = fmt::format("the code crashes with signal {} ({})", WTERMSIG(*status), strsignal(WTERMSIG(*status)));
    if (progress.rows == 0) return {unusable, "before the first row, " + what};
    return {differs, fmt::format("{}: {}", row_words(table, progress), what)};
}

/// Runs the rows in another process.
Answer replay_apart(const Table& table, const std::string& object, const Options& options, std::uint64_t& rows) {
    const std::size_t registers = table.inputs.size() * sizeof(rc_register);
    const SharedMemory memory(sizeof(Progress) + registers);
    auto& progress = *new (memory.at()) Progress;
    progress.registers = reinterpret_cast<rc_register*>(memory.at() + sizeof(Progress));
    std::array<int, 2> pipe_ends{};
    if (pipe(pipe_ends.data()) != 0) throw NotRun("there is no pipe");
    const pid_t child = fork();
    if (child < 0) throw NotRun("there is no further process");
    if (child == 0) {
        limit_process();
        const Answer answer = run_rows(table, object, progress);
        const std::string text = static_cast<char>('0' + answer.exit) + answer.words.substr(0, longest_answer);
        _exit(write(pipe_ends[1], text.data(), text.size()) < 0 ? 1 : 0);
    }
    close(pipe_ends[1]);
    const std::optional<int> status = wait_for(child, progress, options.row);
    std::string text(longest_answer + 1, '\0');
    const ssize_t size = status == 0 ? read(pipe_ends[0], text.data(), text.size()) : 0;
    close(pipe_ends[0]);
    rows = progress.rows;
    if (size <= 0) return answer_of_failure(table, progress, status);
    return {static_cast<Exit>(text[0] - '0'), text.substr(1, static_cast<std::size_t>(size) - 1)};
}

/// Prints one line. The texts of the certificate and of the code are foreign.
Exit report(Exit exit, const std::string& words) {
    constexpr std::array<const char*, 4> verdicts{"REPLAYED", "DIFFERS", "UNUSABLE", "NOT RUN"};
    fmt::print("{} {}\n", verdicts.at(exit), diagnostics::escape_for_display(words));
    return exit;
}

Exit replay(const Options& options) {
    try {
        const Table table = read_table(options.certificate);
        std::string error;
        const diagnostics::TemporaryFolder work("", error);
        if (!error.empty()) throw NotRun(error);
        if (!options.object.empty() && !fs::is_regular_file(options.object))
            throw Unusable(fmt::format("there is no object {}", options.object));
        const std::string object =
            options.object.empty() ? build_object(table, work.path()) : fs::absolute(options.object).string();
        std::uint64_t rows = 0;
        const Answer answer = replay_apart(table, object, options, rows);
        if (answer.exit != replayed) return report(answer.exit, answer.words);
        return report(replayed,
                      fmt::format("{} rows: the code of {} does what the table states", rows, table.component));
    } catch (const Unusable& reason) {
        return report(unusable, reason.what());
    } catch (const NotRun& reason) {
        return report(not_run, reason.what());
    } catch (const std::bad_alloc&) {
        return report(not_run, "there is no more memory");
    } catch (const fs::filesystem_error& error) {
        return report(not_run, error.what());
    }
}

/// Reads the arguments. Returns no value if they are wrong.
std::optional<Options> read_arguments(const std::vector<std::string>& words) {
    Options options;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool option = words[i] == "--object" || words[i] == "--row-timeout";
        if (option && ++i == words.size()) return std::nullopt;
        const std::string& word = words[i];
        if (word.empty() || (!option && word[0] == '-')) return std::nullopt;
        if (option && words[i - 1] == "--row-timeout") {
            options.row = std::chrono::seconds(std::strtol(word.c_str(), nullptr, 10));
            if (options.row.count() < 1) return std::nullopt;
            continue;
        }
        std::string& place = option ? options.object : options.certificate;
        if (!place.empty()) return std::nullopt;
        place = word;
    }
    if (options.certificate.empty()) return std::nullopt;
    return options;
}

int run(const std::vector<std::string>& words) {
    if (std::ranges::find(words, "--help") != words.end()) {
        fmt::print("{}", usage);
        return replayed;
    }
    const std::optional<Options> options = read_arguments(words);
    if (options) return replay(*options);
    fmt::print(stderr, "robochart-replay: one certificate is needed\n{}", usage);
    return wrong_use;
}

}  // namespace

}  // namespace robochart::replay

int main(int count, char** arguments) {
    return robochart::replay::run({arguments + 1, arguments + count});
}
