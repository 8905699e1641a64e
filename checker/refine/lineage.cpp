// Select on a bit vector: a binary search over the counts of blocks, then over one block's words.
#include "checker/refine/lineage.hpp"

#include <algorithm>
#include <bit>

namespace robochart::refine {
namespace {

constexpr std::uint64_t word_bits = 64;
constexpr std::uint64_t block_words = 32;

std::uint64_t place_of_one(std::uint64_t word, std::uint64_t number) {
    for (; number != 0; --number) word &= word - 1;
    return static_cast<std::uint64_t>(std::countr_zero(word));
}

}  // namespace

void Lineage::append(bool bit) {
    if (size_ % word_bits == 0) {
        if (words_.size() % block_words == 0) ones_before_.push_back(ones_);
        words_.push_back(0);
    }
    if (bit) {
        words_.back() |= std::uint64_t{1} << (size_ % word_bits);
        ++ones_;
    }
    ++size_;
}

void Lineage::expanded(std::uint32_t found) {
    for (; found != 0; --found) append(true);
    append(false);
}

lts::StateIndex Lineage::parent(lts::StateIndex state) const {
    const std::uint64_t one = state - 1U;  // counted from 0
    const auto block = std::upper_bound(ones_before_.begin(), ones_before_.end(), one) - ones_before_.begin() - 1;
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
