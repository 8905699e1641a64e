// SPDX-License-Identifier: Apache-2.0
// The set of visited states. Stores the packed states, all of one width, in the order of insertion. Stored states never
// move in memory. A hash table finds candidates by some bits of the hash. A look-up always compares the whole state.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <functional>

#include "checker/lts/index_table.hpp"
#include "checker/lts/transition_system.hpp"

namespace robochart::lts {

/// Stores each packed state once and numbers the states. All states have the same width.
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

    /// Returns the approximate number of bytes that the states and their entries in the table use.
    [[nodiscard]] std::uint64_t bytes() const;
    /// Returns the number of states that fit into `bytes` if each state needs `more` additional bytes elsewhere. The
    /// result is at least 64 and at most 2^31.
    [[nodiscard]] static std::uint64_t most_in(std::uint64_t bytes, std::size_t width, std::uint64_t more = 0);

    // To look up many states quickly: call `hash` and `prefetch` for several of them, and look them up when the
    // processor has loaded their memory.
    [[nodiscard]] static std::uint64_t hash(StateView state);
    void prefetch(std::uint64_t hash) const { table_.prefetch(hash); }
    Insertion insert(StateView state, std::uint64_t hash);
    [[nodiscard]] StateIndex find(StateView state, std::uint64_t hash) const;

    // With the following functions, several threads add the new states that they find at the same time. A state
    // first gets a claim: a provisional number from `first_claim` on. Claims are ordered like the final numbers. If
    // several threads find the same state, the smallest claim wins. When all threads have made their claims, one
    // thread calls `make_space`. After that, several threads publish the claimed states with their final numbers, or
    // drop them.
    static constexpr StateIndex most_claims = StateIndex{1} << 27U;
    static constexpr StateIndex first_claim = no_state - most_claims;
    struct Claim {
        StateIndex index =
            no_state;  ///< the state's number, or its smallest claim so far; no_state if the table is full
        IndexTable::Slot slot;
    };
    /// Claims `number` for a state. Calls `claims.keep_state(state)`, which stores the state, before it makes the
    /// claim. Calls `claims.lose_claim(n)` if a smaller claim replaces the claim n. `claims.row(n)` must return the
    /// state of the claim n.
    template <class Claims>
    Claim claim(StateView state, std::uint64_t hash, StateIndex number, Claims& claims) {
        assert(state.size() == width_);
        // Claims must not look like numbers of states, or like the number that marks a dropped state.
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
    /// Sets the number of states and allocates their memory. Afterwards, the caller must publish the added states.
    void make_space(std::uint64_t states);
    void publish_state(const IndexTable::Slot& slot, StateIndex index, StateView state);
    static void give_up(const IndexTable::Slot& slot) { slot.set(no_state); }

    /// A function that calls `piece` with 0, 1, ... count-1, in any order and concurrently.
    using Sharing = std::function<void(std::size_t count, const std::function<void(std::size_t)>& piece)>;
    /// Returns the number of states that can be added before the table must grow.
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
    /// Returns true if the state with this number equals `state`. Returns false if the number marks a dropped state.
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
