// The end of the program. What consists of many small pieces takes long to take apart, gigabytes of them for seconds;
// once nothing more is asked it is left as it is, and the system takes all memory back at once.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

namespace robochart::diagnostics {

/// The program has its answer, or a limit ends it for good: from now on nothing large is taken apart. Set by the run.
inline std::atomic<bool> program_ends{false};

/// For destructors of what is large: takes it apart, unless the program ends.
template <class T>
void discard(std::unique_ptr<T>& large) {
    if (!program_ends) return large.reset();
    static std::vector<T*>& kept = *new std::vector<T*>();  // so that tools that look for leaks know of it
    kept.push_back(large.release());
}

}  // namespace robochart::diagnostics
