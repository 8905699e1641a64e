// SPDX-License-Identifier: Apache-2.0
// Simulates a full disk: the program's files cannot grow.
#pragma once

#include <sys/resource.h>

#include <csignal>

namespace robochart::tests {

/// During its lifetime no file can grow beyond this number of bytes: writing fails, and the process receives no signal.
class FileLimit {
public:
    explicit FileLimit(rlim_t bytes) : before_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &usual_);
        rlimit small = usual_;
        small.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &small);
    }
    FileLimit(const FileLimit&) = delete;
    FileLimit& operator=(const FileLimit&) = delete;
    ~FileLimit() {
        setrlimit(RLIMIT_FSIZE, &usual_);
        std::signal(SIGXFSZ, before_);
    }

private:
    void (*before_)(int);
    rlimit usual_{};
};

}  // namespace robochart::tests
