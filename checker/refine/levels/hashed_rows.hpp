// Rows one after the other with their hashes, so that memory works on several look-ups at once.
#pragma once

#include <algorithm>
#include <array>

#include "checker/lts/state_store.hpp"

namespace robochart::refine {

/// `prefetch(hash)` of some rows is called before `visit(row, hash)` of the first of them. `rows`: a multiple of
/// `width` words, at least one.
template <class Prefetch, class Visit>
void each_hashed(lts::StateView rows, std::size_t width, const Prefetch& prefetch, const Visit& visit) {
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
