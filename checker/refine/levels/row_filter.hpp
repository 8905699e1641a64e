// Which rows there may be: some bits of the hash of each, in buckets of one cache line. It never misses a row that was
// added. The more rows there are, the fewer bits it keeps of each, so that it never takes more memory than it was
// given.
//
// A bucket has parts, of which each row has its own by other bits of its hash, so that a look-up compares hardly one
// row; how many rows each part has is written in unary (Pandey et al., Vector quotient filters, SIGMOD 2021).
#pragma once

#include <cstdint>

#include "checker/lts/pages.hpp"

namespace robochart::refine {

class RowFilter {
public:
    /// Of each hash `most_bits` are kept, 1 to 32, or the next fewer of 24, 16 and 8 for which all rows fit into
    /// `most_bytes`, and those by which one row in all is hardly taken for another; where not even 8 fit, it may have
    /// every row.
    RowFilter(unsigned most_bits, std::uint64_t most_bytes);

    /// Forgets all rows and gets ready for so many, and for some more where there is memory for them.
    void reset(std::uint64_t rows);
    /// How many rows it is made for; 0: it may have every row, and none is added.
    [[nodiscard]] std::uint64_t capacity() const { return capacity_; }
    [[nodiscard]] std::uint64_t size() const { return size_; }
    /// There must be space: size() < capacity().
    void add(std::uint64_t hash);
    [[nodiscard]] bool may_have(std::uint64_t hash) const;
    /// With which probability, about, it may have a row that was not added.
    [[nodiscard]] double error() const;
    void prefetch(std::uint64_t hash) const {
        if (buckets_ > 0) __builtin_prefetch(bucket(home_of(hash)));
    }
    [[nodiscard]] std::uint64_t bytes() const { return buckets_ * line; }

private:
    static constexpr std::size_t line = 64;

    void keep_bits(unsigned bits);
    [[nodiscard]] static double errors_with(unsigned bits, std::uint64_t buckets);
    /// Of twenty places nineteen are taken at most: buckets that are full pass rows on to the next.
    [[nodiscard]] std::uint64_t space_in(std::uint64_t buckets) const { return buckets * places_ * 19 / 20; }
    /// The bucket, and in the lower half of its product the part, are in the upper half of the hash; what is kept is in
    /// the lower one.
    [[nodiscard]] std::uint64_t home_of(std::uint64_t hash) const { return ((hash >> 32U) * buckets_) >> 32U; }
    [[nodiscard]] unsigned part_of(std::uint64_t hash) const {
        return static_cast<unsigned>(((((hash >> 32U) * buckets_) & 0xFFFFFFFFU) * parts_) >> 32U);
    }
    [[nodiscard]] std::uint8_t* bucket(std::uint64_t number) const {
        return static_cast<std::uint8_t*>(memory_.get()) + number * line;
    }
    [[nodiscard]] bool has(const std::uint8_t* bucket, std::uint64_t counts, unsigned part, std::uint32_t wanted) const;

    unsigned most_bits_;
    std::uint64_t most_bytes_;
    unsigned bytes_of_row_ = 0;
    std::uint32_t mask_ = 0;
    /// Of a bucket. Before them is a word that says how many are taken by each part: as many ones, and a zero; its top
    /// bit, whether all are.
    unsigned places_ = 0;
    unsigned parts_ = 0;  ///< of a bucket
    lts::Pages memory_;
    std::uint64_t buckets_ = 0;
    std::uint64_t capacity_ = 0;
    std::uint64_t size_ = 0;
    std::uint64_t full_ = 0;  ///< buckets
};

}  // namespace robochart::refine
