// Locks of files (flock), also of those of other machines: NFS makes them of locks of byte ranges (flock(2), "NFS
// details"). It gives a lock that excludes others only for a file that is open for writing, and locks folders for its
// own machine alone.
#pragma once

#include <string>

#include "diagnostics/descriptor.hpp"

namespace robochart::storage {

/// What others may have at the same time.
enum class Lock {
    shared,    ///< shared locks
    exclusive  ///< nothing
};

/// Opens a regular file for reading and writing, never through a symbolic link. `make`: it is made, empty, where it is
/// not there. Not open, with errno, where that cannot be done.
[[nodiscard]] diagnostics::Descriptor open_to_lock(const std::string& path, bool make);
/// Locks a file that open_to_lock has opened, as long as it is open, without waiting; a lock that it has is replaced.
/// Gives "", or why it cannot be: `in_use` where others have a lock that excludes this one, or where another file has
/// taken the place of this one.
[[nodiscard]] std::string lock(const diagnostics::Descriptor& file, const std::string& path, Lock kind,
                               const std::string& in_use);

}  // namespace robochart::storage
