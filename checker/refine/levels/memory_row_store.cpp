// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/levels/memory_row_store.hpp"

#include <algorithm>
#include <cassert>

namespace robochart::refine {

RowStore::Found MemoryRowStore::enter_row(lts::StateView row, std::uint64_t hash) {
    const lts::StateStore::Insertion insertion = rows_.insert(row, hash);
    if (insertion.fresh) return Found::fresh;
    return insertion.index < begin(levels()) ? Found::earlier : Found::again;
}

std::size_t MemoryRowStore::read(Level level, std::uint64_t first, std::size_t most, std::vector<lts::Word>& rows) {
    assert(level < ends_.size());
    const std::uint64_t from = std::min(begin(level) + first, end(level));
    const std::uint64_t to = std::min(from + most, end(level));
    for (std::uint64_t index = from; index != to; ++index) {
        const lts::StateView row = rows_[static_cast<lts::StateIndex>(index)];
        rows.insert(rows.end(), row.begin(), row.end());
    }
    return to - from;
}

/// Counts the words of each row and its place in a table. The table is three quarters full and has twelve places in
/// each cache line.
std::uint64_t MemoryRowStore::bytes() const {
    constexpr std::uint64_t line = 64, per_line = 12;
    return rows_.size() * (width() * sizeof(lts::Word) + line * 4 / (3 * per_line));
}

}  // namespace robochart::refine
