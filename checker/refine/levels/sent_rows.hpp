// SPDX-License-Identifier: Apache-2.0
// Stores the rows that a rank has sent recently, so that the rank does not send them again. This table saves work,
// because neighbouring rows often have the same successors. The table fits into the processor's cache. New rows replace
// old ones, so a rank may send a row again. This is harmless, because the owner of the row stores each row only once.
// The table compares whole rows, so it never takes a new row for a sent row.
#pragma once

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>
#include <vector>

#include "checker/lts/state_store.hpp"

namespace robochart::refine {

class SentRows {
public:
    /// `width`: the number of words in a row.
    explicit SentRows(std::size_t width) : width_(width) {}

    /// Sets the size of the table to at most this many bytes, within the limits of the table. If the table grows, all
    /// rows are removed.
    void resize_to_fit(std::uint64_t most_bytes);
    /// Returns true if the row has been sent recently. Records the row as sent. `hash` is lts::StateStore::hash(row).
    bool sent_recently(lts::StateView row, std::uint64_t hash) {
        if (places_ == 0) return false;
        assert(std::has_single_bit(places_) && row.size() == width_ && words_.size() == places_ * (width_ + 1));
        lts::Word* const place = words_.data() + (hash >> 24U & (places_ - 1)) * (width_ + 1);
        const lts::Word mark = static_cast<lts::Word>(hash) | 1U;
        if (place[0] == mark && std::equal(row.begin(), row.end(), place + 1)) return true;
        place[0] = mark;
        std::ranges::copy(row, place + 1);
        return false;
    }
    /// Removes all rows, because their owners have dropped the rows that they received.
    void clear() { std::ranges::fill(words_, 0); }
    /// Returns the memory use in bytes.
    [[nodiscard]] std::uint64_t bytes() const { return words_.size() * sizeof(lts::Word); }

private:
    std::size_t width_;
    std::size_t places_ = 0;        // a power of two, or 0
    std::vector<lts::Word> words_;  // for each place: a part of the hash, not 0; then the row. 0: empty
};

}  // namespace robochart::refine
