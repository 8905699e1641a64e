// Which rows a rank has sent lately, so that it does not send them again: successors of neighbouring rows are often the
// same. Its owner knows a row that it has got once. Small enough for the processor's cache; it forgets, but never takes
// one row for another, since rows are compared as a whole.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "checker/lts/state_store.hpp"

namespace robochart::refine {

class SentRows {
public:
    /// `width`: words of a row.
    explicit SentRows(std::size_t width) : width_(width) {}

    /// May take so many bytes from now on, within bounds of its own. Where that lets it become larger, it forgets all.
    void fit(std::uint64_t most_bytes);
    /// Whether the row is one of those sent lately; from now on it is. `hash` is lts::StateStore::hash(row).
    bool again(lts::StateView row, std::uint64_t hash) {
        if (places_ == 0) return false;
        lts::Word* const place = words_.data() + (hash >> 24U & (places_ - 1)) * (width_ + 1);
        const lts::Word mark = static_cast<lts::Word>(hash) | 1U;
        if (place[0] == mark && std::equal(row.begin(), row.end(), place + 1)) return true;
        place[0] = mark;
        std::copy(row.begin(), row.end(), place + 1);
        return false;
    }
    /// Forgets all: owners no longer know what they have got.
    void clear() { std::fill(words_.begin(), words_.end(), 0); }
    /// In memory.
    [[nodiscard]] std::uint64_t bytes() const { return words_.size() * sizeof(lts::Word); }

private:
    std::size_t width_;
    std::size_t places_ = 0;        // a power of two, or none
    std::vector<lts::Word> words_;  // of each place: a part of the hash, not 0; then the row. 0: no row
};

}  // namespace robochart::refine
