// Pieces of work by several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace robochart::prism {

/// As many threads as asked for; 0: one a core.
[[nodiscard]] unsigned threads_wanted(unsigned asked);

/// Calls `work` with each number below `count` and with the number of the thread that does it, by at most so many
/// threads, the caller's among them. After an exception no further number is begun; the exception of the least number
/// that has one is thrown when all have come back.
void in_parallel(std::size_t count, unsigned threads,
                 const std::function<void(std::size_t number, unsigned thread)>& work);

}  // namespace robochart::prism
