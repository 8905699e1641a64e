// SPDX-License-Identifier: Apache-2.0
// Compiles and loads code; see shared_library.hpp. The flags separate two loaded controllers: each symbol is local to
// its object (hidden visibility, RTLD_LOCAL), and inline variables are not merged across objects (-fno-gnu-unique).
// Otherwise one controller would use the other's tables, and every comparison would succeed.
#include "cpp_emit/load/shared_library.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <thread>

extern char** environ;

namespace robochart::cpp_emit {

namespace fs = std::filesystem;

namespace {

/// The environment for a program whose temporary files go to this folder. A killed program does not delete its files.
std::vector<std::string> environment_within(const fs::path& folder) {
    std::vector<std::string> result{"TMPDIR=" + fs::absolute(folder).string()};
    for (char** entry = environ; *entry != nullptr; ++entry)
        if (!std::string_view(*entry).starts_with("TMPDIR=")) result.emplace_back(*entry);
    return result;
}

std::vector<char*> as_argv(const std::vector<std::string>& words) {
    std::vector<char*> result;
    for (const std::string& word : words) result.push_back(const_cast<char*>(word.c_str()));
    result.push_back(nullptr);
    return result;
}

/// Starts the program with default signal handling, independently of this program's. It leads a process group, so that
/// it can be killed with all its child processes. Returns 0 and sets `error` if it cannot be started.
pid_t start_program(const std::vector<std::string>& command, const std::string& log, std::string& error) {
    assert(!command.empty());
    const std::vector<char*> arguments = as_argv(command);
    const std::vector<std::string> variables = environment_within(fs::path(log).parent_path());
    const std::vector<char*> environment = as_argv(variables);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW,
                                     0600);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    sigset_t usual;
    sigemptyset(&usual);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU, SIGXFSZ}) sigaddset(&usual, signal);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &usual);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    pid_t child = 0;
    const int spawned =
        posix_spawnp(&child, arguments.front(), &actions, &attributes, arguments.data(), environment.data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (spawned == 0) return child;
    error = fmt::format("cannot run {}: {}", command.front(), std::strerror(spawned));
    return 0;
}

/// Polls until the program has ended. Does not reap the process, so that its number is not reused.
void wait_within(pid_t child, diagnostics::Budget& budget) {
    siginfo_t ended{};
    const auto running = [&] {
        return waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid == 0;
    };
    // Most programs end soon, so the first pause is short. It grows for programs that take longer.
    auto pause = std::chrono::milliseconds(1);
    for (; running(); std::this_thread::sleep_for(pause)) {
        budget.check();
        pause = std::min(pause * 2, std::chrono::milliseconds(20));
    }
}

/// Reaps an ended program and returns its exit status; -1 if the status is lost.
int collect_status(pid_t child) {
    assert(child > 0);
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

int run_program(const std::vector<std::string>& command, const std::string& log, std::string& error,
                diagnostics::Budget* budget) {
    const pid_t child = start_program(command, log, error);
    if (child == 0) return -1;
    const diagnostics::Budget::Held held(budget, child);
    try {
        if (budget != nullptr) wait_within(child, *budget);
    } catch (const diagnostics::LimitReached&) {
        kill(-child, SIGKILL);
        (void)collect_status(child);
        throw;
    }
    const int status = collect_status(child);
    if (status < 0) error = fmt::format("lost {}: {}", command.front(), std::strerror(errno));
    return status;
}

namespace {

std::string read_file(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::vector<std::string> split_words(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> found;
    for (std::string word; in >> word;) found.push_back(word);
    return found;
}

std::vector<std::string> command_line(const BuildOptions& options, const fs::path& folder,
                                      const std::vector<std::string>& sources, const std::string& target) {
    std::vector<std::string> command{options.compiler};
    for (std::string& flag : split_words(options.flags)) command.push_back(std::move(flag));
    command.insert(command.end(), {"-shared", "-fPIC", "-fvisibility=hidden", "-I", folder.string(), "-o", target});
    // absolute paths, because a compiler does not accept "-x" and "@x" as file names
    for (const std::string& source : sources) command.push_back(fs::absolute(folder / source).string());
    return command;
}

/// Whether the compiler ran out of memory. In that case its failure is no evidence about the code.
bool lacked_memory(const std::string& output) {
    const auto says = [&](const char* words) { return output.find(words) != std::string::npos; };
    return says("memory exhausted") || says("out of memory") || says("annot allocate memory") ||
           says("Killed signal") || says("std::bad_alloc");
}

bool compile_sources(const BuildOptions& options, const fs::path& folder, const std::vector<std::string>& sources,
                     const std::string& target, std::string& error) {
    std::vector<std::string> command = command_line(options, folder, sources, target);
    command.insert(command.begin() + 1, "-fno-gnu-unique");
    const std::string log = target + ".log";
    int status = run_program(command, log, error, options.budget);
    std::string output = read_file(log);
    if (status > 0 && output.find("no-gnu-unique") != std::string::npos) {
        command.erase(command.begin() + 1);  // clang has no unique symbols and does not know this option
        status = run_program(command, log, error, options.budget);
        output = read_file(log);
    }
    std::error_code ignored;
    fs::remove(log, ignored);
    if (status < 0)
        throw NoCompiler(
            fmt::format("{}: a C++ compiler is needed here; on Debian, `apt install g++` installs one", error));
    if (status > 0 && lacked_memory(output))
        throw diagnostics::LimitReached(fmt::format("{} was given no more memory", options.compiler));
    if (status > 0) error = fmt::format("{} failed with status {}:\n{}", options.compiler, status, output);
    return status == 0;
}

/// The inputs of a compilation other than its command line: the identity of the compiler, from its version text and its
/// file, and the folders that the environment adds to its search path. No value if the compiler does not answer.
std::optional<std::string> compiler_identity(const BuildOptions& options, const fs::path& folder) {
    std::string error;
    const std::string log = (folder / "version.log").string();
    if (run_program({options.compiler, "--version"}, log, error, options.budget) != 0) return std::nullopt;
    std::string identity = read_file(log);
    std::error_code ignored;
    fs::remove(log, ignored);
    for (const char* variable : {"CPATH", "CPLUS_INCLUDE_PATH", "LIBRARY_PATH", "COMPILER_PATH", "GCC_EXEC_PREFIX"})
        if (const char* const value = std::getenv(variable)) identity += fmt::format("{}={}\n", variable, value);
    return identity;
}

/// A key for the cache. Equal keys mean that files and compilers produce the same object.
std::optional<diagnostics::Digest> key_of(const std::vector<OutputFile>& files, const std::vector<std::string>& sources,
                                          const BuildOptions& options, const fs::path& folder) {
    if (options.cache == nullptr) return std::nullopt;
    const auto identity = compiler_identity(options, folder);
    if (!identity) return std::nullopt;
    diagnostics::Hasher hasher;
    for (const std::string& part : {std::string("object"), options.compiler, options.flags, *identity})
        hasher.add(std::string_view(part));
    hasher.add(sources.size());
    for (const std::string& source : sources) hasher.add(std::string_view(source));
    for (const OutputFile& file : files) {
        hasher.add(std::string_view(file.path));
        hasher.add(std::string_view(file.text));
    }
    return hasher.finish();
}

/// Copies an object that an earlier run has compiled to `path`. Returns false if the cache has no such object.
bool restore_object(const std::optional<diagnostics::Digest>& key, const BuildOptions& options,
                    const std::string& path) {
    if (!key) return false;
    const auto object = options.cache->find(*key);
    if (!object) return false;
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    return out.write(object->data(), static_cast<std::streamsize>(object->size())).flush().good();
}

/// Each build gets a unique name, because the loader would return a loaded object with the same name.
std::string object_name(const fs::path& folder, std::string& error) {
    std::string name = (folder / "controller-XXXXXX.so").string();
    const int file = mkstemps(name.data(), 3);
    if (file < 0) {
        error = fmt::format("cannot write in {}: {}", folder.string(), std::strerror(errno));
        return "";
    }
    close(file);
    return name;
}

}  // namespace

std::unique_ptr<SharedLibrary> SharedLibrary::build(const std::vector<OutputFile>& files,
                                                    const std::vector<std::string>& sources,
                                                    const BuildOptions& options, std::string& error) {
    std::unique_ptr<SharedLibrary> object(new SharedLibrary);
    std::error_code failed;
    object->folder_ = options.work_dir;
    if (options.work_dir.empty()) {
        object->temporary_ = std::make_unique<diagnostics::TemporaryFolder>("", error, options.budget);
        object->folder_ = object->temporary_->path();
        if (object->folder_.empty()) return nullptr;
    } else {
        fs::create_directories(object->folder_, failed);
    }
    for (const OutputFile& file : files) {
        error = diagnostics::write_below(object->folder_, file.path, file.text);
        if (!error.empty()) return nullptr;
    }
    object->path_ = object_name(object->folder_, error);
    if (object->path_.empty()) return nullptr;
    const auto key = key_of(files, sources, options, object->folder_);
    if (!restore_object(key, options, object->path_)) {
        if (!compile_sources(options, object->folder_, sources, object->path_, error)) return nullptr;
        if (key) options.cache->store_entry(*key, read_file(object->path_));
    }
    if (!object->load_library(error)) return nullptr;
    return object;
}

bool SharedLibrary::load_library(std::string& error) {
    handle_ = dlopen(fs::absolute(path_).c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_ == nullptr) error = fmt::format("cannot load the generated code: {}", dlerror());
    return handle_ != nullptr;
}

void* SharedLibrary::find_symbol(const char* name) const {
    assert(handle_ != nullptr);
    return dlsym(handle_, name);
}

SharedLibrary::~SharedLibrary() {
    if (handle_ != nullptr) dlclose(handle_);
    std::error_code ignored;
    if (temporary_ == nullptr && !path_.empty()) fs::remove(path_, ignored);
}

}  // namespace robochart::cpp_emit
