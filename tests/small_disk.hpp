// SPDX-License-Identifier: Apache-2.0
// Provides a small disk for tests that need more than a limit on the size of single files.
#pragma once

#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <string>

namespace robochart::tests {

inline void write_to(const char* path, const std::string& text) {
    const int file = ::open(path, O_WRONLY | O_CLOEXEC);
    if (file < 0) return;
    (void)!::write(file, text.data(), text.size());
    ::close(file);
}

/// Runs `work` in its own process, with a disk of this size in KiB at `folder`. Returns the result of `work` (less than
/// 100), 100 if the system allows no such disk, or 101 if the process ends in another way.
inline int on_small_disk(const std::string& folder, unsigned kibibytes, const std::function<int()>& work) {
    const pid_t child = fork();
    if (child == 0) {
        int result = 101;
        try {
            const std::string user = "0 " + std::to_string(getuid()) + " 1",
                              group = "0 " + std::to_string(getgid()) + " 1";
            bool own = unshare(CLONE_NEWNS) == 0;
            if (!own && unshare(CLONE_NEWUSER | CLONE_NEWNS) == 0) {
                own = true;
                write_to("/proc/self/setgroups", "deny");
                write_to("/proc/self/uid_map", user);
                write_to("/proc/self/gid_map", group);
            }
            const std::string size = "mode=700,size=" + std::to_string(kibibytes) + "k";
            if (!own || mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
                mount("none", folder.c_str(), "tmpfs", 0, size.c_str()) != 0)
                _exit(100);
            result = work();
        } catch (...) {
        }
        _exit(result);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status)) return 101;
    return WEXITSTATUS(status);
}

}  // namespace robochart::tests
