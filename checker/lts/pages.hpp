// SPDX-License-Identifier: Apache-2.0
// Allocates zeroed memory for large tables, in huge pages if the system provides them. The memory of a page is
// allocated when it is first accessed. Huge pages save time: with pages of 4 KiB, a random look-up also reads the page
// table and takes 1.7 times as long.
#pragma once

#include <cstddef>
#include <memory>

namespace robochart::lts {

struct FreePages {
    std::size_t bytes = 0;
    void operator()(void* memory) const;
};
/// Memory that is aligned to a cache line.
using Pages = std::unique_ptr<void, FreePages>;

/// Allocates at least this many zeroed bytes. Throws std::bad_alloc.
[[nodiscard]] Pages zeroed_pages(std::size_t bytes);

}  // namespace robochart::lts
