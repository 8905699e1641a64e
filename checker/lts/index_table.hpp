// SPDX-License-Identifier: Apache-2.0
// A hash table for objects that are stored elsewhere: it stores only their numbers. The table uses open addressing with
// buckets of one cache line. For each of its twelve numbers, a bucket also stores eight bits of the object's hash. A
// look-up usually reads one cache line, and then only the objects whose eight bits match.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cassert>
#include <cstdint>
#include <limits>

#include "checker/lts/pages.hpp"

namespace robochart::lts {

using StateIndex = std::uint32_t;
inline constexpr StateIndex no_state = std::numeric_limits<StateIndex>::max();

class IndexTable {
    struct Bucket;

public:
    /// A slot that contains a number, or a free slot for a new number.
    class Slot {
    public:
        [[nodiscard]] bool is_taken() const { return taken_; }
        [[nodiscard]] StateIndex get() const { return index().load(std::memory_order_acquire); }
        void set(StateIndex number) const { index().store(number, std::memory_order_relaxed); }
        void prefetch() const { __builtin_prefetch(bucket_, 1); }
        /// Replaces the number if it is still `expected`; otherwise stores the current number in `expected`.
        bool replace(StateIndex& expected, StateIndex number) const {
            return index().compare_exchange_strong(expected, number, std::memory_order_acq_rel);
        }

    private:
        friend class IndexTable;
        [[nodiscard]] std::atomic_ref<StateIndex> index() const {
            assert(bucket_ != nullptr && place_ < bucket_size);
            return std::atomic_ref(bucket_->index[place_]);
        }
        Bucket* bucket_ = nullptr;
        std::uint32_t place_ = 0;
        std::uint8_t tag_ = 0;
        bool taken_ = false;
    };

    IndexTable() { reset(1); }

    /// Returns the slot with the number that satisfies `same`. If no number satisfies it, returns a free slot. If the
    /// table is full, the returned slot has no bucket.
    template <class Same>
    [[nodiscard]] Slot find(std::uint64_t hash, const Same& same) const {
        Slot slot;
        slot.tag_ = static_cast<std::uint8_t>(hash);
        std::uint32_t home = home_of(hash);
        for (std::uint32_t tried = 0; tried < bucket_count_; ++tried) {
            Bucket& bucket = buckets()[home];
            const std::uint32_t used = bucket.used & ~locked;
            if (find_match(slot, bucket, 0, used, same)) return slot;
            if (used < bucket_size) {
                slot.bucket_ = &bucket;
                slot.place_ = used;
                return slot;
            }
            if (++home == bucket_count_) home = 0;
        }
        return slot;
    }
    [[nodiscard]] static bool has_space(const Slot& slot) { return slot.bucket_ != nullptr; }
    /// Stores a number in a free slot. After the slot was found, no other number may have been added.
    static void put_number(const Slot& slot, StateIndex index) {
        assert(!slot.taken_ && slot.place_ == slot.bucket_->used);
        slot.set(index);
        slot.bucket_->set_tag(slot.place_, slot.tag_);
        ++slot.bucket_->used;
    }
    /// Adds a number that is not in the table. Returns false if there is no free slot.
    bool add(std::uint64_t hash, StateIndex index) {
        std::uint32_t home = home_of(hash);
        for (std::uint32_t tried = 0; tried < bucket_count_; ++tried) {
            Bucket& bucket = buckets()[home];
            if (bucket.used < bucket_size) {
                bucket.index[bucket.used] = index;
                assert((bucket.used & locked) == 0);  // no other thread adds numbers
                bucket.set_tag(bucket.used++, static_cast<std::uint8_t>(hash));
                return true;
            }
            if (++home == bucket_count_) home = 0;
        }
        return false;
    }

    /// Thread-safe. Returns the slot with the number that satisfies `same`. If no number does, calls `own` and stores
    /// the number that `own` returns. A thread that finds the stored number sees all data that were written before
    /// `own` returned.
    template <class Same, class Own>
    [[nodiscard]] Slot find_or_add(std::uint64_t hash, const Same& same, const Own& own) const {
        Slot slot;
        slot.tag_ = static_cast<std::uint8_t>(hash);
        std::uint32_t home = home_of(hash);
        for (std::uint32_t tried = 0; tried < bucket_count_; ++tried) {
            Bucket& bucket = buckets()[home];
            for (std::uint32_t known = 0;;) {
                const std::uint32_t used = bucket.await_used_count();
                if (find_match(slot, bucket, known, used, same)) return slot;
                if (used == bucket_size) break;
                known = used;
                if (!bucket.lock(used)) continue;
                assert(used < bucket_size && !slot.taken_);
                slot.bucket_ = &bucket;
                slot.place_ = used;
                slot.set(own());
                bucket.set_tag(used, slot.tag_);
                bucket.unlock(used + 1);
                return slot;
            }
            if (++home == bucket_count_) home = 0;
        }
        return slot;
    }

    /// Prefetches the cache line that a look-up reads first.
    void prefetch(std::uint64_t hash) const { __builtin_prefetch(&buckets()[home_of(hash)]); }

    /// Returns the maximal number of entries with which look-ups are fast.
    [[nodiscard]] std::uint64_t capacity() const { return std::uint64_t{bucket_count_} * bucket_size * 4 / 5; }
    /// Removes all entries and allocates space for at least this many numbers.
    void reset_for_capacity(std::uint64_t numbers);

private:
    static constexpr std::uint32_t bucket_size = 12;
    static constexpr std::uint32_t locked = 0x80;  // in `used`: a thread is adding a number
    static_assert(std::endian::native == std::endian::little, "tags are found by their place in a word");

    struct alignas(64) Bucket {
        std::array<StateIndex, bucket_size> index;
        std::uint64_t first_tags;
        std::uint32_t last_tags;
        std::uint32_t used;

        /// Returns one bit for each place from `first` on whose tag matches.
        [[nodiscard]] std::uint64_t matching_tags(std::uint8_t tag, std::uint32_t first, std::uint32_t end);
        [[nodiscard]] static std::uint32_t lowest_match(std::uint64_t matches) {
            assert(matches != 0 && matches >> bucket_size == 0);
            return static_cast<std::uint32_t>(std::countr_zero(matches));
        }
        /// No other thread may use the bucket during this call.
        void set_tag(std::uint32_t place, std::uint8_t tag);
        /// Waits until no thread is adding a number. Returns the number of used places.
        [[nodiscard]] std::uint32_t await_used_count() {
            for (;;) {
                const std::uint32_t now = std::atomic_ref(used).load(std::memory_order_acquire);
                if ((now & locked) == 0) return now;
            }
        }
        [[nodiscard]] bool lock(std::uint32_t expected) {
            return std::atomic_ref(used).compare_exchange_strong(expected, expected | locked,
                                                                 std::memory_order_acquire);
        }
        void unlock(std::uint32_t now) {
            assert(now > 0 && now <= bucket_size);
            std::atomic_ref(used).store(now, std::memory_order_release);
        }
    };

    /// Searches the places [first, end) of a bucket for a number that satisfies `same`.
    template <class Same>
    [[nodiscard]] static bool find_match(Slot& slot, Bucket& bucket, std::uint32_t first, std::uint32_t end,
                                         const Same& same) {
        for (std::uint64_t matches = bucket.matching_tags(slot.tag_, first, end); matches != 0;
             matches &= matches - 1) {
            slot.bucket_ = &bucket;
            slot.place_ = Bucket::lowest_match(matches);
            slot.taken_ = same(slot.get());
            if (slot.taken_) return true;
        }
        slot.bucket_ = nullptr;
        return false;
    }

    void reset(std::uint32_t bucket_count);
    [[nodiscard]] Bucket* buckets() const { return static_cast<Bucket*>(memory_.get()); }
    [[nodiscard]] std::uint32_t home_of(std::uint64_t hash) const {
        assert(bucket_count_ > 0);
        return static_cast<std::uint32_t>(((hash >> 32U) * bucket_count_) >> 32U);
    }

    Pages memory_;
    std::uint32_t bucket_count_ = 0;
};

inline void IndexTable::Bucket::set_tag(std::uint32_t place, std::uint8_t tag) {
    constexpr std::uint32_t first_places = sizeof first_tags;
    assert(place < bucket_size);
    // Each place is used only once. Its bits are still 0, so `or` sets them.
    assert((place < first_places ? first_tags >> (8 * place) : last_tags >> (8 * (place - first_places))) % 256 == 0);
    if (place < first_places)
        std::atomic_ref(first_tags).store(first_tags | std::uint64_t{tag} << (8 * place), std::memory_order_relaxed);
    else
        std::atomic_ref(last_tags).store(last_tags | std::uint32_t{tag} << (8 * (place - first_places)),
                                         std::memory_order_relaxed);
}

inline std::uint64_t IndexTable::Bucket::matching_tags(std::uint8_t tag, std::uint32_t first, std::uint32_t end) {
    assert(first <= end && end <= bucket_size);
    constexpr std::uint64_t ones = 0x0101010101010101ULL;
    constexpr std::uint64_t tops = ones << 7U;
    const auto agreeing = [tag](std::uint64_t tags) {
        const std::uint64_t differing = tags ^ (ones * tag);
        const std::uint64_t low = (differing & ~tops) + ~tops;  // a top bit is set if a lower bit of its byte differs
        return (~(low | differing) & tops) >> 7U;               // bit 0 of each matching byte
    };
    const auto gathered = [](std::uint64_t bits) { return (bits * 0x0102040810204080ULL) >> 56U; };
    const std::uint64_t front = std::atomic_ref(first_tags).load(std::memory_order_relaxed);
    const std::uint64_t back = std::atomic_ref(last_tags).load(std::memory_order_relaxed);
    const std::uint64_t all = gathered(agreeing(front)) | (gathered(agreeing(back)) & 0xfU) << 8U;
    return all & ((std::uint64_t{1} << end) - 1) & ~((std::uint64_t{1} << first) - 1);
}

}  // namespace robochart::lts
