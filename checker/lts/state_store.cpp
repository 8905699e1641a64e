// Linear probing; a slot's home is its tag scaled to the segment's length, so that a segment may have any length.
#include "checker/lts/state_store.hpp"

#include <algorithm>
#include <stdexcept>

namespace robochart::lts {
namespace {

constexpr std::size_t first_length = 8;

std::uint64_t hash_of(StateView state) {
    std::uint64_t hash = 0x2545F4914F6CDD1DULL;
    for (Word word : state) {
        hash = (hash ^ word) * 0x9E3779B97F4A7C15ULL;
        hash ^= hash >> 32U;
    }
    hash *= 0xD6E8FEB86659FD93ULL;
    return hash ^ (hash >> 29U);
}

std::size_t home(std::uint32_t tag, std::size_t length) {
    return static_cast<std::size_t>((static_cast<std::uint64_t>(tag) * length) >> 32U);
}

std::size_t next(std::size_t slot, std::size_t length) {
    return slot + 1 == length ? 0 : slot + 1;
}

}  // namespace

StateStore::StateStore(std::size_t width) : width_(width) {}

StateView StateStore::operator[](StateIndex index) const {
    return {&chunks_[index / states_per_chunk][(index % states_per_chunk) * width_], width_};
}

std::size_t StateStore::find_slot(const Segment& segment, std::uint32_t tag, StateView state) const {
    const std::size_t length = segment.slots.size();
    std::size_t slot = home(tag, length);
    for (;; slot = next(slot, length)) {
        const Slot& candidate = segment.slots[slot];
        if (candidate.index == no_state) return slot;
        if (candidate.tag != tag) continue;
        const StateView other = (*this)[candidate.index];
        if (std::equal(state.begin(), state.end(), other.begin())) return slot;
    }
}

void StateStore::grow(Segment& segment) {
    std::vector<Slot> larger(std::max(first_length, segment.slots.size() * 3 / 2));
    for (const Slot& slot : segment.slots) {
        if (slot.index == no_state) continue;
        std::size_t place = home(slot.tag, larger.size());
        while (larger[place].index != no_state) place = next(place, larger.size());
        larger[place] = slot;
    }
    segment.slots.swap(larger);
}

StateIndex StateStore::append(StateView state) {
    if (size_ >= no_state) throw std::length_error("more than 2^32 states");
    if (size_ % states_per_chunk == 0) chunks_.push_back(std::make_unique<Word[]>(states_per_chunk * width_));
    std::copy(state.begin(), state.end(), &chunks_.back()[(size_ % states_per_chunk) * width_]);
    return static_cast<StateIndex>(size_++);
}

StateStore::Insertion StateStore::insert(StateView state) {
    const std::uint64_t hash = hash_of(state);
    Segment& segment = segments_[hash >> (64U - segment_bits)];
    const auto tag = static_cast<std::uint32_t>(hash);
    if (segment.used * 5 >= segment.slots.size() * 4) grow(segment);
    Slot& slot = segment.slots[find_slot(segment, tag, state)];
    if (slot.index != no_state) return {slot.index, false};
    slot = {append(state), tag};
    ++segment.used;
    return {slot.index, true};
}

StateIndex StateStore::find(StateView state) const {
    const std::uint64_t hash = hash_of(state);
    const Segment& segment = segments_[hash >> (64U - segment_bits)];
    if (segment.slots.empty()) return no_state;
    return segment.slots[find_slot(segment, static_cast<std::uint32_t>(hash), state)].index;
}

}  // namespace robochart::lts
