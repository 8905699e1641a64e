// A hash table from things that lie elsewhere to their numbers: open addressing over buckets of one cache line, twelve
// numbers each with eight bits of its hash. A look-up reads one line, most often, and the things whose eight bits
// agree.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

#include "checker/lts/pages.hpp"

namespace robochart::lts {

using StateIndex = std::uint32_t;
inline constexpr StateIndex no_state = std::numeric_limits<StateIndex>::max();

class IndexTable {
    struct Bucket;

public:
    /// Where a number stands, or where it can be put.
    class Slot {
    public:
        [[nodiscard]] bool taken() const { return taken_; }
        [[nodiscard]] StateIndex get() const { return bucket_->index[place_]; }
        void set(StateIndex index) const { bucket_->index[place_] = index; }

    private:
        friend class IndexTable;
        Bucket* bucket_ = nullptr;
        std::uint32_t place_ = 0;
        std::uint8_t tag_ = 0;
        bool taken_ = false;
    };

    IndexTable() { reset(1); }

    /// The slot of the number for which `same` is true. Without one a free slot; its bucket is none if there is no
    /// room.
    template <class Same>
    [[nodiscard]] Slot find(std::uint64_t hash, const Same& same) const {
        Slot slot;
        slot.tag_ = static_cast<std::uint8_t>(hash);
        std::uint32_t home = home_of(hash);
        for (std::uint32_t tried = 0; tried < segment_length_; ++tried) {
            Bucket& bucket = buckets()[home];
            for (std::uint64_t matches = bucket.matches(slot.tag_); matches != 0; matches &= matches - 1) {
                slot.place_ = bucket.place(matches);
                if (!same(bucket.index[slot.place_])) continue;
                slot.bucket_ = &bucket;
                slot.taken_ = true;
                return slot;
            }
            if (bucket.used < bucket_size) {
                slot.bucket_ = &bucket;
                slot.place_ = bucket.used;
                return slot;
            }
            if (++home % segment_length_ == 0) home -= segment_length_;
        }
        return slot;
    }
    [[nodiscard]] static bool has_room(const Slot& slot) { return slot.bucket_ != nullptr; }
    /// Puts a number into a free slot, before any other is put into the table.
    static void put(const Slot& slot, StateIndex index) {
        slot.bucket_->index[slot.place_] = index;
        slot.bucket_->tag[slot.place_] = slot.tag_;
        ++slot.bucket_->used;
    }
    /// Puts a number that is not in the table. False if there is no room.
    bool add(std::uint64_t hash, StateIndex index) {
        const Slot slot = find(hash, [](StateIndex) { return false; });
        if (has_room(slot)) put(slot, index);
        return has_room(slot);
    }

    /// The line that a look-up will read first.
    void prefetch(std::uint64_t hash) const { __builtin_prefetch(&buckets()[home_of(hash)]); }
    /// A number in the first line whose hash agrees, as far as the line knows; or no_state.
    [[nodiscard]] StateIndex likely(std::uint64_t hash) const {
        const Bucket& bucket = buckets()[home_of(hash)];
        const std::uint64_t matches = bucket.matches(static_cast<std::uint8_t>(hash));
        return matches == 0 ? no_state : bucket.index[bucket.place(matches)];
    }

    /// How many numbers it is made for; beyond that, look-ups become slow.
    [[nodiscard]] std::uint64_t capacity() const { return std::uint64_t{bucket_count_} * bucket_size * 4 / 5; }
    /// Forgets everything and gets ready for at least so many numbers.
    void grow(std::uint64_t numbers);

    /// Look-ups with hashes of different segments touch different memory.
    [[nodiscard]] std::uint32_t segment(std::uint64_t hash) const {  // home_of(hash) / segment_length_
        return static_cast<std::uint32_t>(((hash >> 32U) * segments_) >> 32U);
    }
    static constexpr std::uint32_t most_segments = 64;

private:
    static constexpr std::uint32_t bucket_size = 12;
    static_assert(std::endian::native == std::endian::little, "tags are found by their place in a word");

    struct alignas(64) Bucket {
        std::array<StateIndex, bucket_size> index;
        std::array<std::uint8_t, bucket_size> tag;
        std::uint8_t used;

        /// One bit for each tag that agrees.
        [[nodiscard]] std::uint64_t matches(std::uint8_t wanted) const;
        [[nodiscard]] static std::uint32_t place(std::uint64_t matches) {
            return static_cast<std::uint32_t>(std::countr_zero(matches));
        }
    };

    void reset(std::uint32_t bucket_count);
    [[nodiscard]] Bucket* buckets() const { return static_cast<Bucket*>(memory_.get()); }
    [[nodiscard]] std::uint32_t home_of(std::uint64_t hash) const {
        return static_cast<std::uint32_t>(((hash >> 32U) * bucket_count_) >> 32U);
    }

    Pages memory_;
    std::uint32_t bucket_count_ = 0;
    std::uint32_t segments_ = 1;
    std::uint32_t segment_length_ = 1;
};

inline std::uint64_t IndexTable::Bucket::matches(std::uint8_t wanted) const {
    constexpr std::uint64_t ones = 0x0101010101010101ULL;
    constexpr std::uint64_t tops = ones << 7U;
    const auto agreeing = [wanted](std::uint64_t tags) {
        const std::uint64_t differing = tags ^ (ones * wanted);
        const std::uint64_t low = (differing & ~tops) + ~tops;  // top bit: some lower bit differs
        return (~(low | differing) & tops) >> 7U;               // bit 0 of each byte that agrees
    };
    const auto gathered = [](std::uint64_t bits) { return (bits * 0x0102040810204080ULL) >> 56U; };
    std::uint64_t first = 0;
    std::uint32_t rest = 0;
    std::memcpy(&first, tag.data(), sizeof first);
    std::memcpy(&rest, tag.data() + sizeof first, sizeof rest);
    const std::uint64_t all = gathered(agreeing(first)) | (gathered(agreeing(rest)) & 0xfU) << 8U;
    return all & ((std::uint64_t{1} << used) - 1);
}

}  // namespace robochart::lts
