// SPDX-License-Identifier: Apache-2.0
// Stores the new states of one block of a wide level (parallel_level.hpp), in the order of discovery. The addresses of
// states never change, so that other threads can compare with a state while states are added.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cassert>
#include <cstdint>
#include <memory>

#include "checker/lts/state_store.hpp"

namespace robochart::refine {

class ProvisionalStates {
public:
    struct Claim {
        lts::IndexTable::Slot slot;
        std::uint32_t pair = 0;  ///< the pair that found the state, counted from the first pair of the block
        bool lost = false;       ///< true if a smaller claim has replaced this one
    };
    static constexpr std::uint32_t most = std::uint32_t{1} << 20U;

    void clear(std::size_t width) {
        width_ = width;
        size_ = 0;
    }
    [[nodiscard]] std::uint32_t size() const { return size_; }
    [[nodiscard]] Claim& operator[](std::uint32_t number) const {
        const Place place = place_of(number);
        assert(place.chunk < chunks_.size() && chunks_[place.chunk].claims != nullptr);
        return chunks_[place.chunk].claims[place.offset];
    }
    [[nodiscard]] const lts::Word* row(std::uint32_t number) const {
        const Place place = place_of(number);
        assert(place.chunk < chunks_.size() && chunks_[place.chunk].words != nullptr);
        return chunks_[place.chunk].words.get() + place.offset * width_;
    }
    /// Allocates memory for this many more states. Returns false if there would be too many.
    bool make_space(std::size_t more) {
        if (size_ + more > most) return false;
        for (std::size_t chunk = 0; chunk <= place_of(static_cast<std::uint32_t>(size_ + more)).chunk; ++chunk) {
            if (chunks_[chunk].words != nullptr) continue;
            chunks_[chunk].claims = std::make_unique<Claim[]>(first_chunk << chunk);
            chunks_[chunk].words = std::make_unique<lts::Word[]>((first_chunk << chunk) * width_ + 1);
        }
        return true;
    }
    /// Stores the state of the next claim.
    void store_state(lts::StateView state) {
        const Place place = place_of(size_);
        std::ranges::copy(state, chunks_[place.chunk].words.get() + place.offset * width_);
        chunks_[place.chunk].claims[place.offset].lost = false;
    }
    /// Completes the next claim. It is called after the claim has been made in the table.
    void add(const lts::IndexTable::Slot& slot, std::uint32_t pair) {
        assert(size_ < most);
        Claim& claim = (*this)[size_++];
        claim.slot = slot;
        claim.pair = pair;
    }
    /// Marks a claim as lost. The thread whose claim has replaced it calls this function.
    void mark_lost(std::uint32_t number) {
        std::atomic_ref((*this)[number].lost).store(true, std::memory_order_relaxed);
    }

private:
    // Chunk k contains first_chunk * 2^k claims.
    static constexpr std::size_t first_chunk = 256;
    struct Chunk {
        std::unique_ptr<Claim[]> claims;
        std::unique_ptr<lts::Word[]> words;
    };
    struct Place {
        std::size_t chunk, offset;
    };
    static Place place_of(std::uint32_t number) {
        const std::size_t place = number + first_chunk;
        const auto chunk = static_cast<std::size_t>(std::bit_width(place) - std::bit_width(first_chunk));
        return {chunk, place - (first_chunk << chunk)};
    }

    std::size_t width_ = 0;
    std::uint32_t size_ = 0;
    std::array<Chunk, 13> chunks_;
};

}  // namespace robochart::refine
