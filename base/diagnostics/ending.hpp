// SPDX-License-Identifier: Apache-2.0
// Makes the end of the program fast. Destroying gigabytes of small objects takes seconds. When no more work follows,
// the program does not destroy them, and the system frees the memory of the process at once.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

namespace robochart::diagnostics {

/// True after the program has its answer, or after a limit has ended its work. From then on, large objects are not
/// destroyed. The run sets this flag.
inline std::atomic<bool> program_ends{false};

/// Destroys a large object, unless the program ends. Destructors of large objects call it for their members.
template <class T>
void discard(std::unique_ptr<T>& large) {
    if (!program_ends) return large.reset();
    static std::vector<T*>& undeleted = *new std::vector<T*>();  // stored, so that leak detectors find it
    undeleted.push_back(large.release());
}

}  // namespace robochart::diagnostics
