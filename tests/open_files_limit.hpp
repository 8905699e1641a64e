// SPDX-License-Identifier: Apache-2.0
// Sets a low limit on open files for tests.
#pragma once

#include <sys/resource.h>
#include <unistd.h>

namespace robochart::tests {

/// During its lifetime the program can open only this number of additional files.
class OpenFilesLimit {
public:
    explicit OpenFilesLimit(int more) {
        getrlimit(RLIMIT_NOFILE, &usual_);
        rlimit few = usual_;
        few.rlim_cur = static_cast<rlim_t>(last_open() + 1 + more);
        setrlimit(RLIMIT_NOFILE, &few);
    }
    OpenFilesLimit(const OpenFilesLimit&) = delete;
    OpenFilesLimit& operator=(const OpenFilesLimit&) = delete;
    ~OpenFilesLimit() { setrlimit(RLIMIT_NOFILE, &usual_); }

private:
    /// Returns the highest descriptor in use. Assumes that no file is open above the lowest free descriptor, which is
    /// almost always true in a test.
    static int last_open() {
        const int next = ::dup(STDERR_FILENO);
        ::close(next);
        return next - 1;
    }
    rlimit usual_{};
};

}  // namespace robochart::tests
