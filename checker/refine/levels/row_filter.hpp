// SPDX-License-Identifier: Apache-2.0
// A filter of rows, which never rejects a row that was added. The filter stores some bits of the hash of each row, in
// buckets of one cache line. The more rows there are, the fewer bits of each row fit into the memory limit.
//
// A bucket consists of parts. Other bits of the hash select the part for a row. So a look-up compares the row with few
// other rows: with less than one row on average, or with about eight rows if only 8 bits of each row are stored. The
// filter stores the number of rows in each part in unary (Pandey et al., Vector quotient filters, SIGMOD 2021).
#pragma once

#include <cstdint>

#include "checker/lts/pages.hpp"

namespace robochart::refine {

class RowFilter {
public:
    /// Creates a filter that stores `most_bits` (1 to 32) bits of each hash. The filter stores only 24, 16 or 8 bits in
    /// two cases: more bits would not fit into `most_bytes`, or the expected number of new rows that the filter accepts
    /// is still negligible. If all rows would not fit with 8 bits, the filter accepts every row.
    RowFilter(unsigned most_bits, std::uint64_t most_bytes);

    /// Removes all rows and prepares for this many rows, and for some more if there is memory for them.
    void reset(std::uint64_t rows);
    /// Returns the maximal number of rows. If it is 0, the filter accepts every row, and no row may be added.
    [[nodiscard]] std::uint64_t capacity() const { return capacity_; }
    [[nodiscard]] std::uint64_t size() const { return size_; }
    /// Precondition: size() < capacity().
    void add(std::uint64_t hash);
    [[nodiscard]] bool may_have(std::uint64_t hash) const;
    /// Returns the approximate probability that the filter accepts a row that was not added.
    [[nodiscard]] double error() const;
    void prefetch(std::uint64_t hash) const {
        if (buckets_ > 0) __builtin_prefetch(bucket(home_of(hash)));
    }
    [[nodiscard]] std::uint64_t bytes() const { return buckets_ * line; }

private:
    static constexpr std::size_t line = 64;

    void keep_bits(unsigned bits);
    [[nodiscard]] static double errors_with(unsigned bits, std::uint64_t buckets);
    /// Returns how many rows may be stored in this many buckets. At most nineteen of twenty places are used. If a
    /// bucket is full, further rows of this bucket are stored in the next bucket.
    [[nodiscard]] std::uint64_t space_in(std::uint64_t buckets) const { return buckets * places_ * 19 / 20; }
    /// Returns the bucket for a hash. Multiply the upper half of the hash by the number of buckets. The upper half of
    /// this product determines the bucket, and the lower half determines the part. The stored bits are bits of the
    /// lower half of the hash.
    [[nodiscard]] std::uint64_t home_of(std::uint64_t hash) const { return ((hash >> 32U) * buckets_) >> 32U; }
    [[nodiscard]] unsigned part_of(std::uint64_t hash) const {
        return static_cast<unsigned>(((((hash >> 32U) * buckets_) & 0xFFFFFFFFU) * parts_) >> 32U);
    }
    [[nodiscard]] std::uint8_t* bucket(std::uint64_t number) const {
        return static_cast<std::uint8_t*>(memory_.get()) + number * line;
    }
    [[nodiscard]] bool bucket_contains(const std::uint8_t* bucket, std::uint64_t counts, unsigned part,
                                       std::uint32_t bits) const;

    unsigned most_bits_;
    std::uint64_t most_bytes_;
    unsigned bytes_of_row_ = 0;
    std::uint32_t mask_ = 0;
    /// The number of places in a bucket. The first word of a bucket precedes the places. For each part, it contains as
    /// many ones as the part has used places, followed by a zero. The top bit of this word is set if all places are
    /// used.
    unsigned places_ = 0;
    unsigned parts_ = 0;  ///< number of parts in a bucket
    lts::Pages memory_;
    std::uint64_t buckets_ = 0;
    std::uint64_t capacity_ = 0;
    std::uint64_t size_ = 0;
    std::uint64_t full_ = 0;  ///< number of full buckets
};

}  // namespace robochart::refine
