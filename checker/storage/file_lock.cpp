// SPDX-License-Identifier: Apache-2.0
#include "checker/storage/file_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>

namespace robochart::storage {

diagnostics::Descriptor open_to_lock(const std::string& path, bool make) {
    const int flags = O_RDWR | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK | (make ? O_CREAT : 0);
    diagnostics::Descriptor file(::open(path.c_str(), flags, 0600));
    struct stat found {};
    if (!file.is_open() || ::fstat(file.get(), &found) != 0) return diagnostics::Descriptor();
    if (S_ISREG(found.st_mode)) return file;
    errno = EINVAL;
    return diagnostics::Descriptor();
}

std::string lock(const diagnostics::Descriptor& file, const std::string& path, Lock kind, const std::string& in_use) {
    if (::flock(file.get(), (kind == Lock::shared ? LOCK_SH : LOCK_EX) | LOCK_NB) != 0) {
        if (errno == EWOULDBLOCK) return in_use;
        return fmt::format("it cannot be locked: {}: the file system must have locks (flock)", std::strerror(errno));
    }
    struct stat locked {};
    struct stat there {};
    const bool same = ::fstat(file.get(), &locked) == 0 && ::lstat(path.c_str(), &there) == 0 &&
                      locked.st_dev == there.st_dev && locked.st_ino == there.st_ino;
    return same ? "" : in_use;
}

}  // namespace robochart::storage
