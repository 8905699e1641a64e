// SPDX-License-Identifier: Apache-2.0
// Locks files with flock. These locks also work across machines, because NFS implements them as locks of byte ranges
// (flock(2), "NFS details"). NFS grants an exclusive lock only for a file that is open for writing, and locks folders
// only on the local machine.
#pragma once

#include <string>

#include "base/diagnostics/descriptor.hpp"

namespace robochart::storage {

/// The kind of a lock: what other processes may do with the file at the same time.
enum class Lock {
    shared,    ///< other processes may have shared locks
    exclusive  ///< no other process may have a lock
};

/// Opens a regular file for reading and writing, but never through a symbolic link. With `make`, creates an empty file
/// if none exists. On failure the returned descriptor is not open and errno is set.
[[nodiscard]] diagnostics::Descriptor open_to_lock(const std::string& path, bool make);
/// Locks a file that open_to_lock has opened; the lock ends when the file is closed. Does not wait. Replaces a lock
/// that this process already has. Returns "" on success, otherwise the reason of the failure. The reason is `in_use` if
/// another process has a conflicting lock, or if another file has replaced this one.
[[nodiscard]] std::string lock(const diagnostics::Descriptor& file, const std::string& path, Lock kind,
                               const std::string& in_use);

}  // namespace robochart::storage
