// A program that may have few files open.
#pragma once

#include <sys/resource.h>
#include <unistd.h>

namespace robochart::tests {

/// While it lives, so many more files can be opened than are open now.
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
    /// There are no gaps below the next number that is free, but perhaps some behind it: hardly any in a test.
    static int last_open() {
        const int next = ::dup(STDERR_FILENO);
        ::close(next);
        return next - 1;
    }
    rlimit usual_{};
};

}  // namespace robochart::tests
