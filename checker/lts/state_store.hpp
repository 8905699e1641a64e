// SPDX-License-Identifier: Apache-2.0
// The set of visited states. It stores exact packed states of one width in the order of insertion. The chunks of memory
// that contain them never move. A table of hash bits finds states, and a look-up always compares the whole state.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <functional>

#include "checker/lts/index_table.hpp"
#include "checker/lts/transition_system.hpp"

namespace robochart::lts {

/// Stores packed states of one width without duplicates and numbers them.
class StateStore {
public:
    explicit StateStore(std::size_t width);

    struct Insertion {
        StateIndex index;
        bool fresh;
    };
    Insertion insert(StateView state) { return insert(state, hash(state)); }
    /// Returns the number of the state, or no_state if the set does not contain it.
    [[nodiscard]] StateIndex find(StateView state) const { return find(state, hash(state)); }
    /// Returns the state with this number. The view stays valid while states are added.
    [[nodiscard]] StateView operator[](StateIndex index) const {
        assert(index < size_);
        return {row(index), width_};
    }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::size_t width() const { return width_; }

    /// Returns the approximate memory in bytes that the states and their places in the table use.
    [[nodiscard]] std::uint64_t bytes() const;
    /// Returns how many states fit into this many bytes if each state needs `more` additional bytes. The result is at
    /// least a small number, and at most the number of valid state numbers.
    [[nodiscard]] static std::uint64_t most_in(std::uint64_t bytes, std::size_t width, std::uint64_t more = 0);

    // To look up many states, call `hash` and `prefetch` for several of them, and look them up when the processor has
    // loaded their memory.
    [[nodiscard]] static std::uint64_t hash(StateView state);
    void prefetch(std::uint64_t hash) const { table_.prefetch(hash); }
    Insertion insert(StateView state, std::uint64_t hash);
    [[nodiscard]] StateIndex find(StateView state, std::uint64_t hash) const;

    // Several threads use the following functions for new states that they find at the same time. A state first gets a
    // claim, which is a provisional number from `first_claim` on. Claims have the same order as the final numbers. If
    // several threads find the same state, the smallest claim wins. When all threads have finished their claims, one
    // thread calls `make_space`. Then several threads publish the remaining states with their final numbers, or drop
    // them.
    static constexpr StateIndex most_claims = StateIndex{1} << 27U;
    static constexpr StateIndex first_claim = no_state - most_claims;
    struct Claim {
        StateIndex index =
            no_state;  ///< the state's number, or its smallest provisional number; no_state: the table is full
        IndexTable::Slot slot;
    };
    /// Claims the number for a state. `claims.row(number)` returns the state of a claim. `claims.keep_state(state)`
    /// stores the state; it is called before the claim is made. `claims.lose_claim(number)` reports that another claim
    /// has replaced this one.
    template <class Claims>
    Claim claim(StateView state, std::uint64_t hash, StateIndex number, Claims& claims) {
        assert(state.size() == width_);
        // A claim must differ from all numbers of states and from the number that marks a dropped state.
        assert(number >= first_claim && number != no_state && size_ <= first_claim);
        const auto same = [&](StateIndex index) {
            if (index < size_) return equals_state(row(index), state);
            return index != no_state && equals_state(claims.row(index), state);
        };
        const auto own = [&] {
            claims.keep_state(state);
            return number;
        };
        const IndexTable::Slot slot = table_.find_or_add(hash, same, own);
        if (!IndexTable::has_space(slot)) return {};
        if (!slot.is_taken()) return {number, slot};
        StateIndex index = slot.get();
        if (index > number) claims.keep_state(state);
        while (index > number) {
            if (!slot.replace(index, number)) continue;
            claims.lose_claim(index);
            return {number, slot};
        }
        return {index, slot};
    }
    /// Sets the number of states and allocates their memory. The added states must then be published.
    void make_space(std::uint64_t states);
    void publish_state(const IndexTable::Slot& slot, StateIndex index, StateView state);
    static void give_up(const IndexTable::Slot& slot) { slot.set(no_state); }

    /// A function that calls `piece` with 0, 1, ... count-1, in any order and concurrently.
    using Sharing = std::function<void(std::size_t count, const std::function<void(std::size_t)>& piece)>;
    /// Returns how many further states fit into the current table.
    [[nodiscard]] std::uint64_t free_state_count() const {
        return table_.capacity() - std::min(table_.capacity(), size_);
    }
    void reserve(std::uint64_t states, const Sharing& share) {
        if (states > table_.capacity()) rebuild_table(states, share);
    }

private:
    // Chunk k holds first_chunk * 2^k states.
    static constexpr std::uint64_t first_chunk = 1024;
    static constexpr std::size_t most_chunks = 23;

    [[nodiscard]] Word* row(StateIndex index) const {
        const std::uint64_t place = index + first_chunk;
        const auto chunk = static_cast<std::size_t>(std::bit_width(place) - std::bit_width(first_chunk));
        assert(chunk < chunk_count_);
        return static_cast<Word*>(chunks_[chunk].get()) + (place - (first_chunk << chunk)) * width_;
    }
    void make_chunks(std::uint64_t states);
    void rebuild_table(std::uint64_t states, const Sharing& share);
    template <class Add>
    bool add_states(StateIndex first, StateIndex end, const Add& add) const;
    /// Compares the state with the one that has this number. Returns false for the number of a dropped state.
    [[nodiscard]] bool equals_state(StateIndex index, StateView state) const {
        return index < size_ && equals_state(row(index), state);
    }
    [[nodiscard]] bool equals_state(const Word* words, StateView state) const {
        for (std::size_t i = 0; i < width_; ++i)
            if (words[i] != state[i]) return false;
        return true;
    }

    std::size_t width_;
    std::uint64_t size_ = 0;
    std::size_t chunk_count_ = 0;
    IndexTable table_;
    std::array<Pages, most_chunks> chunks_;
};

}  // namespace robochart::lts
