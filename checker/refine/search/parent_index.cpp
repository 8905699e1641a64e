// SPDX-License-Identifier: Apache-2.0
// Finds the n-th one of the bit vector ("select"): by a binary search over the counts of blocks, and then over the
// words of one block.
#include "checker/refine/search/parent_index.hpp"

#include <algorithm>
#include <bit>
#include <cassert>

namespace robochart::refine {
namespace {

constexpr std::uint64_t word_bits = 64;
constexpr std::uint64_t block_words = 32;

std::uint64_t place_of_one(std::uint64_t word, std::uint64_t number) {
    for (; number != 0; --number) word &= word - 1;
    return static_cast<std::uint64_t>(std::countr_zero(word));
}

}  // namespace

void ParentIndex::begin_word() {
    if (words_.size() % block_words == 0) ones_before_.push_back(ones_);
    words_.push_back(0);
}

/// Appends the lowest `count` bits, at most a word. The other bits of `bits` must be zero.
void ParentIndex::append(std::uint64_t bits, std::uint32_t count) {
    assert(count > 0 && count <= word_bits && (count == word_bits || bits >> count == 0));
    const auto shift = static_cast<std::uint32_t>(size_ % word_bits);
    if (shift == 0) begin_word();
    words_.back() |= bits << shift;
    if (shift + count > word_bits) {
        const auto fitting = static_cast<std::uint32_t>(word_bits) - shift;
        ones_ += static_cast<std::uint64_t>(std::popcount(bits << shift));
        bits >>= fitting;
        begin_word();
        words_.back() = bits;
    }
    ones_ += static_cast<std::uint64_t>(std::popcount(bits));
    size_ += count;
    assert(words_.size() == (size_ + word_bits - 1) / word_bits && ones_ <= size_);
}

void ParentIndex::add_expanded_state(std::uint32_t found) {
    constexpr std::uint32_t at_once = 32;
    for (; found > at_once; found -= at_once) append((std::uint64_t{1} << at_once) - 1, at_once);
    append((std::uint64_t{1} << found) - 1, found + 1);
}

void ParentIndex::append(const ParentIndex& next) {
    for (std::uint64_t done = 0; done < next.size_; done += word_bits)
        append(next.words_[done / word_bits], static_cast<std::uint32_t>(std::min(word_bits, next.size_ - done)));
}

void ParentIndex::clear() {
    words_.clear();
    ones_before_.clear();
    size_ = 0;
    ones_ = 0;
}

lts::StateIndex ParentIndex::parent(lts::StateIndex state) const {
    const std::uint64_t one = state - 1U;  // index of its one, counted from 0
    assert(state > 0 && one < ones_);
    const auto block = std::ranges::upper_bound(ones_before_, one) - ones_before_.begin() - 1;
    std::uint64_t left = one - ones_before_[static_cast<std::size_t>(block)];
    std::uint64_t word = static_cast<std::uint64_t>(block) * block_words;
    for (;; ++word) {
        const auto here = static_cast<std::uint64_t>(std::popcount(words_[word]));
        if (left < here) break;
        left -= here;
    }
    return static_cast<lts::StateIndex>(word * word_bits + place_of_one(words_[word], left) - one);
}

}  // namespace robochart::refine
