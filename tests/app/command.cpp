// SPDX-License-Identifier: Apache-2.0
#include "tests/app/command.hpp"
#include "tests/contents.hpp"
#include "tests/source_folder.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

namespace robochart::app::testing {
namespace {

using tests::read_contents;

/// Removes a warning that AddressSanitizer prints about the evaluator's own stack, because it is not output of the
/// program.
std::string without_sanitizer_note(std::string text) {
    const std::size_t note = text.find("WARNING: ASan doesn't fully support makecontext");
    if (note == std::string::npos) return text;
    const std::size_t before = text.rfind('\n', note);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    return text.erase(begin, text.find('\n', note) + 1 - begin);
}

void redirect(const char* path, int flags, int to) {
    const int file = open(path, flags, 0600);
    if (file < 0 || dup2(file, to) < 0) _exit(126);
}

[[noreturn]] void become(const std::vector<std::string>& arguments, const std::string& folder) {
    if (chdir(folder.c_str()) != 0) _exit(126);
    redirect("stdin.txt", O_RDONLY, STDIN_FILENO);
    redirect("stdout.txt", O_WRONLY | O_CREAT, STDOUT_FILENO);
    redirect("stderr.txt", O_WRONLY | O_CREAT, STDERR_FILENO);
    std::vector<char*> argv{const_cast<char*>(tests::command_path())};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    execv(tests::command_path(), argv.data());
    _exit(127);
}

using Become = std::function<void(const std::string& folder)>;

/// Runs a child process with this input. `before` runs in the child, `meanwhile` in the parent.
Ran run_child(const Become& become, const std::string& input, const std::function<void()>& before,
              const std::function<void(pid_t)>& meanwhile) {
    const tests::TemporaryFolder folder;
    folder.write("stdin.txt", input);
    const pid_t child = fork();
    if (child == 0) {
        setenv("XDG_CACHE_HOME", folder.path().c_str(), 1);  // so the test does not use the user's caches
        before();
        become(folder.path());
        _exit(127);
    }
    meanwhile(child);
    int status = 0;
    waitpid(child, &status, 0);
    Ran ran;
    ran.exit = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    ran.out = read_contents(folder.in("stdout.txt"));
    ran.err = without_sanitizer_note(read_contents(folder.in("stderr.txt")));
    return ran;
}

Ran run_between(const std::vector<std::string>& arguments, const std::string& input,
                const std::function<void()>& before, const std::function<void(pid_t)>& meanwhile) {
    return run_child([&](const std::string& folder) { become(arguments, folder); }, input, before, meanwhile);
}

bool has_ended(pid_t child) {
    siginfo_t ended{};
    return waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid == child;
}

}  // namespace

Ran run_shell(const std::string& commands) {
    const auto shell = [&](const std::string& folder) {
        if (chdir(folder.c_str()) != 0) _exit(126);
        redirect("stdin.txt", O_RDONLY, STDIN_FILENO);
        redirect("stdout.txt", O_WRONLY | O_CREAT, STDOUT_FILENO);
        redirect("stderr.txt", O_WRONLY | O_CREAT, STDERR_FILENO);
        setenv("verify", tests::command_path(), 1);
        execl("/bin/sh", "sh", "-c", commands.c_str(), nullptr);
    };
    return run_child(
        shell, "", [] {}, [](pid_t) {});
}

Ran run(const std::vector<std::string>& arguments, const std::string& input) {
    return run_between(
        arguments, input, [] {}, [](pid_t) {});
}

Ran run_and_signal(const std::vector<std::string>& arguments, int signal, const Wait& wait) {
    return run_between(
        arguments, "", [] {},
        [&](pid_t child) {
            if (wait) {
                wait([child] { return has_ended(child); });
            } else {
                usleep(1'500'000);
            }
            kill(child, signal);
        });
}

Ran run_with_address_space(const std::vector<std::string>& arguments, std::uint64_t bytes) {
    const auto restrict = [bytes] {
        const rlimit limit{bytes, bytes};
        setrlimit(RLIMIT_AS, &limit);
    };
    return run_between(arguments, "", restrict, [](pid_t) {});
}

TemporaryFile::TemporaryFile(const std::string& name, const std::string& text) : path_(folder_.write(name, text)) {}

Folder::Folder(const std::vector<std::pair<std::string, std::string>>& files) {
    for (const auto& [name, text] : files) folder_.write(name, text);
}

std::string repository(const std::string& path) {
    return tests::source_folder().string() + "/" + path;
}

}  // namespace robochart::app::testing
