// Zeroed memory for large tables: huge pages where the system has them, taken from it as they are touched. (A random
// look-up in a table of 4 KiB pages costs a walk of the page table as well: 1.7 times the time.)
#pragma once

#include <cstddef>
#include <memory>

namespace robochart::lts {

struct FreePages {
    std::size_t bytes = 0;
    void operator()(void* memory) const;
};
/// Starts on a cache line.
using Pages = std::unique_ptr<void, FreePages>;

/// Throws std::bad_alloc.
[[nodiscard]] Pages zeroed_pages(std::size_t bytes);

}  // namespace robochart::lts
