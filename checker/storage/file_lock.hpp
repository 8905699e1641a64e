// SPDX-License-Identifier: Apache-2.0
// File locks (flock), which also work across machines: NFS implements them by locks of byte ranges (flock(2), "NFS
// details"). NFS grants an exclusive lock only for a file that is open for writing, and locks folders only on the local
// machine.
#pragma once

#include <string>

#include "base/diagnostics/descriptor.hpp"

namespace robochart::storage {

/// The kind of a lock: which locks other processes may have on the file at the same time.
enum class Lock {
    shared,    ///< shared locks
    exclusive  ///< no access
};

/// Opens a regular file for reading and writing, never through a symbolic link. With `make`, an empty file is created
/// if none exists. On failure the descriptor is not open and errno is set.
[[nodiscard]] diagnostics::Descriptor open_to_lock(const std::string& path, bool make);
/// Locks a file that open_to_lock has opened, until it is closed. Does not wait, and replaces a lock that this process
/// already has. Returns "" or the reason of the failure: `in_use` if another process has a conflicting lock, or if
/// another file has replaced this one.
[[nodiscard]] std::string lock(const diagnostics::Descriptor& file, const std::string& path, Lock kind,
                               const std::string& in_use);

}  // namespace robochart::storage
