// SPDX-License-Identifier: Apache-2.0
// Visits rows and their hashes in batches, so that the processor loads memory for several look-ups at once.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>

#include "checker/lts/state_store.hpp"

namespace robochart::refine {

/// Calls `prefetch(hash)` for several rows before it calls `visit(row, hash)` for the first of them. The size of `rows`
/// is a multiple of `width` words. There must be at least one row.
template <class Prefetch, class Visit>
void each_hashed(lts::StateView rows, std::size_t width, const Prefetch& prefetch, const Visit& visit) {
    assert(rows.size() % width == 0);
    constexpr std::size_t ahead = 64;
    std::array<std::uint64_t, ahead> hashes{};
    const std::size_t count = rows.size() / width;
    for (std::size_t first = 0; first < count; first += ahead) {
        const std::size_t end = std::min(count, first + ahead);
        for (std::size_t i = first; i < end; ++i) {
            hashes[i - first] = lts::StateStore::hash(rows.subspan(i * width, width));
            prefetch(hashes[i - first]);
        }
        for (std::size_t i = first; i < end; ++i) visit(rows.subspan(i * width, width), hashes[i - first]);
    }
}

}  // namespace robochart::refine
