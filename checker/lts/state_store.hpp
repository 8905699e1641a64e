// The visited set: exact packed states of one width, numbered in the order of insertion. The states lie in that order
// in chunks that never move; a table of hash bits finds them, and every hit compares the whole state.
#pragma once

#include <array>
#include <cstdint>

#include "checker/lts/index_table.hpp"
#include "checker/lts/transition_system.hpp"

namespace robochart::lts {

class StateStore {
public:
    explicit StateStore(std::size_t width);

    struct Insertion {
        StateIndex index;
        bool fresh;
    };
    Insertion insert(StateView state) { return insert(state, hash(state)); }
    [[nodiscard]] StateIndex find(StateView state) const { return find(state, hash(state)); }  ///< or no_state
    /// The view stays valid while states are added.
    [[nodiscard]] StateView operator[](StateIndex index) const { return {row(index), width_}; }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::size_t width() const { return width_; }

    // Many states at a time: hash and prefetch one, go on with others, come back to it when memory has answered.
    [[nodiscard]] static std::uint64_t hash(StateView state);
    void prefetch(std::uint64_t hash) const { table_.prefetch(hash); }
    /// After prefetch: the state that probably is the one with this hash.
    void prefetch_state(std::uint64_t hash) const {
        const StateIndex likely = table_.likely(hash);
        if (likely < size_) __builtin_prefetch(row(likely));  // others have claims, but no place yet
    }
    Insertion insert(StateView state, std::uint64_t hash);
    [[nodiscard]] StateIndex find(StateView state, std::uint64_t hash) const;

    // New states entered by several threads, in three steps with all threads waiting for each other in between. First
    // `reserve` by one; then `claim` by the owner of the hash's segment, each with a number from size() on that stands
    // for the state until it has its own; then `make_room` by one; then `publish` by the owners.
    struct Claim {
        StateIndex index = no_state;  ///< none: there is no room
        IndexTable::Slot slot;
    };
    [[nodiscard]] std::uint32_t segment(std::uint64_t hash) const { return table_.segment(hash); }
    /// Makes room in the table for so many states altogether.
    void reserve(std::uint64_t states) {
        if (states > table_.capacity()) grow(states);
    }
    /// The number of the state, or of an equal claim before. `row_of` gives the state of a claim's number.
    template <class RowOf>
    Claim claim(StateView state, std::uint64_t hash, StateIndex number, const RowOf& row_of) {
        const auto same = [&](StateIndex index) {
            return index < size_ ? equal(index, state) : equal(row_of(index).data(), state);
        };
        Claim claim{no_state, table_.find(hash, same)};
        if (claim.slot.taken()) return {claim.slot.get(), claim.slot};
        if (!IndexTable::has_room(claim.slot)) return claim;
        IndexTable::put(claim.slot, number);
        return {number, claim.slot};
    }
    /// From now on there are so many states; those added are published next.
    void make_room(std::uint64_t states);
    void publish(const IndexTable::Slot& slot, StateIndex index, StateView state);

private:
    // Chunk k holds first_chunk * 2^k states.
    static constexpr std::uint64_t first_chunk = 1024;
    static constexpr std::size_t most_chunks = 23;

    [[nodiscard]] Word* row(StateIndex index) const {
        const std::uint64_t place = index + first_chunk;
        const auto chunk = static_cast<std::size_t>(std::bit_width(place) - std::bit_width(first_chunk));
        return static_cast<Word*>(chunks_[chunk].get()) + (place - (first_chunk << chunk)) * width_;
    }
    void make_chunks(std::uint64_t states);
    void grow(std::uint64_t states);
    [[nodiscard]] bool equal(StateIndex index, StateView state) const { return equal(row(index), state); }
    [[nodiscard]] bool equal(const Word* words, StateView state) const {
        for (std::size_t i = 0; i < width_; ++i)
            if (words[i] != state[i]) return false;
        return true;
    }

    std::size_t width_;
    std::size_t size_ = 0;
    std::size_t chunk_count_ = 0;
    IndexTable table_;
    std::array<Pages, most_chunks> chunks_;
};

}  // namespace robochart::lts
