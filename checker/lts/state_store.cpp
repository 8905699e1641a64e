// SPDX-License-Identifier: Apache-2.0
#include "checker/lts/state_store.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <new>
#include <stdexcept>

namespace robochart::lts {

std::uint64_t StateStore::hash(StateView state) {
    constexpr std::uint64_t factor = 0x9E3779B97F4A7C15ULL;
    std::uint64_t hash = 0x2545F4914F6CDD1DULL;
    std::size_t i = 0;
    for (; i + 1 < state.size(); i += 2) {
        hash = (hash ^ (state[i] | std::uint64_t{state[i + 1]} << 32U)) * factor;
        hash ^= hash >> 32U;
    }
    if (i < state.size()) {
        hash = (hash ^ state[i]) * factor;
        hash ^= hash >> 32U;
    }
    hash *= 0xD6E8FEB86659FD93ULL;
    return hash ^ (hash >> 32U);
}

StateStore::StateStore(std::size_t width) : width_(width) {}

template <class Add>
bool StateStore::add_states(StateIndex first, StateIndex end, const Add& add) const {
    constexpr std::uint64_t ahead = 16;
    std::array<std::uint64_t, ahead> hashes{};
    for (std::uint64_t next = first; next < end + ahead; ++next) {
        std::uint64_t& slot = hashes[next % ahead];
        if (next >= first + ahead && !add(slot, static_cast<StateIndex>(next - ahead))) return false;
        if (next >= end) continue;
        slot = hash((*this)[static_cast<StateIndex>(next)]);
        table_.prefetch(slot);
    }
    return true;
}

/// Rebuilds the table from the states in order. The old table is freed first, so that both never exist at the same
/// time.
void StateStore::rebuild_table(std::uint64_t states, const Sharing& share) {
    constexpr std::uint64_t piece = 1U << 16U;
    const auto all = static_cast<StateIndex>(size_);
    const auto add_alone = [this](std::uint64_t hash, StateIndex index) { return table_.add(hash, index); };
    const auto add = [this](std::uint64_t hash, StateIndex index) {
        return IndexTable::has_space(table_.find_or_add(
            hash, [](StateIndex) { return false; }, [index] { return index; }));
    };
    for (std::uint64_t capacity = states;; capacity += capacity / 2) {
        table_.reset_for_capacity(capacity);
        if (!share || size_ < 2 * piece) {
            if (add_states(0, all, add_alone)) return;
            continue;
        }
        std::atomic<bool> complete = true;
        share((size_ + piece - 1) / piece, [&](std::size_t number) {
            const auto first = static_cast<StateIndex>(number * piece);
            const auto end = static_cast<StateIndex>(std::min<std::uint64_t>(size_, first + piece));
            if (complete && !add_states(first, end, add)) complete = false;
        });
        if (complete) return;
    }
}

void StateStore::make_chunks(std::uint64_t states) {
    if (states > no_state) throw std::length_error("more than 2^32 states");
    while ((first_chunk << chunk_count_) - first_chunk < states) {
        const std::size_t words = (first_chunk << chunk_count_) * width_;
        assert(chunk_count_ < most_chunks);
        chunks_[chunk_count_] = zeroed_pages(std::max<std::size_t>(words, 1) * sizeof(Word));
        ++chunk_count_;
    }
}

StateStore::Insertion StateStore::insert(StateView state, std::uint64_t hash) {
    assert(state.size() == width_);
    const auto same = [&](StateIndex index) { return equals_state(index, state); };
    IndexTable::Slot slot = table_.find(hash, same);
    if (slot.is_taken()) return {slot.get(), false};
    if (size_ >= table_.capacity() || !IndexTable::has_space(slot)) {
        rebuild_table(size_ + 1, {});
        slot = table_.find(hash, same);
        if (!IndexTable::has_space(slot)) throw std::bad_alloc();
    }
    make_chunks(size_ + 1);
    assert(size_ < no_state);
    const auto index = static_cast<StateIndex>(size_);
    std::ranges::copy(state, row(index));
    IndexTable::put_number(slot, index);
    ++size_;
    return {index, true};
}

void StateStore::make_space(std::uint64_t states) {
    make_chunks(states);
    assert(states >= size_);
    size_ = states;
}

void StateStore::publish_state(const IndexTable::Slot& slot, StateIndex index, StateView state) {
    assert(index < size_ && state.size() == width_);
    slot.set(index);
    std::ranges::copy(state, row(index));
}

StateIndex StateStore::find(StateView state, std::uint64_t hash) const {
    assert(state.size() == width_);
    const IndexTable::Slot slot = table_.find(hash, [&](StateIndex index) { return equals_state(index, state); });
    return slot.is_taken() ? slot.get() : no_state;
}

/// Returns the memory of the states plus that of the table. A bucket of the table has 64 bytes and twelve places. At
/// most four fifths of the places are used.
std::uint64_t StateStore::bytes() const {
    return size_ * width_ * sizeof(Word) + (size_ + free_state_count()) * 5 / 4 * 64 / 12;
}

/// Assumes that two thirds of the table are used, so that each state takes 8 bytes there. A new chunk is as large as
/// all chunks before it. If less than half of the last chunk would be used, the result does not include it.
std::uint64_t StateStore::most_in(std::uint64_t bytes, std::size_t width, std::uint64_t more) {
    constexpr std::uint64_t fewest = 64, most = std::uint64_t{1} << 31U, place = 8;
    const std::uint64_t states = std::min(bytes / (width * sizeof(Word) + place + more), most);
    const std::uint64_t last_chunk = std::bit_floor(states + first_chunk);
    const std::uint64_t before = last_chunk - first_chunk;
    return std::max(fewest, before > 0 && states - before < last_chunk / 2 ? before : states);
}

}  // namespace robochart::lts
