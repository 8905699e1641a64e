// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/levels/rows_aside.hpp"

#include <algorithm>
#include <cassert>

#include "checker/storage/sort_rows.hpp"

namespace robochart::refine {

using lts::StateIndex;
using lts::StateStore;
using lts::StateView;
using lts::Word;

/// Reserves memory for each row in the store, and for a copy of each row with its level while rows are passed on.
RowsAside::RowsAside(const std::string& path, const storage::RowKind& kind, std::uint64_t bytes)
    : most_(StateStore::most_in(bytes, kind.width, (kind.width + 1) * sizeof(Word))),
      store_(std::make_unique<StateStore>(kind.width)),
      runs_(path, storage::with_level(kind)) {}

void RowsAside::add(StateView row, std::uint64_t hash, Level level) {
    if (store_->size() >= most_) {
        if (store_->find(row, hash) != lts::no_state) return;
        write();
    }
    const auto [index, fresh] = store_->insert(row, hash);
    if (fresh && (levels_.empty() || levels_.back().first != level)) levels_.emplace_back(level, index);
}

std::vector<Word> RowsAside::with_levels(StateIndex first, StateIndex end) const {
    assert(first <= end);
    std::vector<Word> rows;
    rows.reserve((end - first) * (width() + 1));
    auto level = std::ranges::upper_bound(levels_, first, {}, &decltype(levels_)::value_type::second);
    for (StateIndex i = first; i < end; ++i) {
        while (level != levels_.end() && level->second <= i) ++level;
        rows.insert(rows.end(), (*store_)[i].begin(), (*store_)[i].end());
        assert(level != levels_.begin());  // the first row of the store has a level
        rows.push_back(std::prev(level)->first);
    }
    return rows;
}

/// Writes the rows in memory as a run. If an exception is thrown, no row is lost: each row is in the store, in
/// `unwritten_` or in a run at all times.
void RowsAside::write() {
    if (unwritten_.empty()) {
        auto next = std::make_unique<StateStore>(width());
        next->reserve(most_, {});  // the old store was full, and the new one will be, too
        unwritten_ = with_levels(0, static_cast<StateIndex>(store_->size()));
        levels_.clear();
        store_ = std::move(next);
    }
    storage::sort_rows(unwritten_, width() + 1);
    runs_.add(unwritten_);
    unwritten_ = {};
}

void RowsAside::each_piece(const std::function<void(std::vector<Word>& rows)>& take) const {
    if (!runs_.empty()) each_of_runs(take);
    std::vector<Word> rows;
    const auto give = [&] {
        storage::sort_rows(rows, width() + 1);
        take(rows);
    };
    if (!unwritten_.empty()) {
        rows = unwritten_;
        give();
    }
    // rows exist twice while they are sorted
    const auto size = static_cast<StateIndex>(store_->size());
    const StateIndex piece = std::max<StateIndex>(size / 2 + size % 2, 32);
    for (StateIndex first = 0; first < size; first += piece) {
        rows = with_levels(first, std::min(size, first + piece));
        give();
    }
}

/// Merges the runs. Among copies of a row, the one with the least level comes first.
void RowsAside::each_of_runs(const std::function<void(std::vector<Word>& rows)>& take) const {
    const std::size_t words = width() + 1;
    const std::size_t full = most_ * words;
    std::vector<Word> rows;
    rows.reserve(std::min(full, runs_.rows() * words));
    std::vector<Word> last;
    runs_.merge([&](std::span<const Word> merged) {
        for (std::size_t at = 0; at < merged.size(); at += words) {
            const StateView row = merged.subspan(at, words);
            if (!last.empty() && std::equal(last.begin(), last.end() - 1, row.begin())) continue;
            last.assign(row.begin(), row.end());
            if (rows.size() >= full) {
                take(rows);
                rows.clear();
            }
            rows.insert(rows.end(), row.begin(), row.end());
        }
    });
    if (!rows.empty()) take(rows);
}

void RowsAside::clear() {
    store_ = std::make_unique<StateStore>(width());
    levels_.clear();
    unwritten_ = {};
    runs_.clear();
}

std::uint64_t RowsAside::bytes() const {
    return store_->bytes() + levels_.capacity() * sizeof(levels_[0]) + unwritten_.capacity() * sizeof(Word) +
           runs_.bytes();
}

}  // namespace robochart::refine
