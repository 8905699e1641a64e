// SPDX-License-Identifier: Apache-2.0
#include "base/diagnostics/programs.hpp"

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
#include <cstring>
#include <filesystem>
#include <thread>

extern char** environ;

namespace robochart::diagnostics {

namespace fs = std::filesystem;

namespace {

/// Returns the environment for a program whose temporary files are to be in this folder. A killed program does not
/// delete its files.
std::vector<std::string> environment_within(const fs::path& folder) {
    std::vector<std::string> result{"TMPDIR=" + fs::absolute(folder).string()};
    for (char** entry = environ; *entry != nullptr; ++entry)
        if (!std::string_view(*entry).starts_with("TMPDIR=")) result.emplace_back(*entry);
    return result;
}

std::vector<char*> as_argv(const std::vector<std::string>& words) {
    std::vector<char*> result;
    result.reserve(words.size() + 1);
    for (const std::string& word : words) result.push_back(const_cast<char*>(word.c_str()));
    result.push_back(nullptr);
    return result;
}

/// Starts the program. It has the default signal handling, even if this program has changed its own. It leads a process
/// group, so that it can be killed with all its child processes. Returns 0 and sets `error` if it cannot be started.
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

/// Waits until the program has ended, and polls the budget. Does not reap the process, so that its number is not
/// reused.
void wait_within(pid_t child, Budget& budget) {
    siginfo_t ended{};
    const auto running = [&] {
        return waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid == 0;
    };
    // Most programs end soon, so the first pause is short. The pauses become longer for programs that take longer.
    auto pause = std::chrono::milliseconds(1);
    for (; running(); std::this_thread::sleep_for(pause)) {
        budget.check();
        pause = std::min(pause * 2, std::chrono::milliseconds(20));
    }
}

/// Reaps an ended program and returns its exit status, or -1 if the status is lost.
int collect_status(pid_t child) {
    assert(child > 0);
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

int run_program(const std::vector<std::string>& command, const std::string& log, std::string& error, Budget* budget) {
    const pid_t child = start_program(command, log, error);
    if (child == 0) return -1;
    const Budget::Held held(budget, child);
    try {
        if (budget != nullptr) wait_within(child, *budget);
    } catch (const LimitReached&) {
        kill(-child, SIGKILL);
        (void)collect_status(child);
        throw;
    }
    const int status = collect_status(child);
    if (status < 0) error = fmt::format("lost {}: {}", command.front(), std::strerror(errno));
    return status;
}

}  // namespace robochart::diagnostics
