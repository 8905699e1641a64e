// Which rows there may be: a few bits of the hash of each, in buckets of one cache line. It never misses a row that was
// added; that it has one which was not happens with a probability of about 2^-(bits - 4) for each question.
#pragma once

#include <cstdint>

#include "checker/lts/pages.hpp"

namespace robochart::refine {

class RowFilter {
public:
    /// `bits` of each hash are kept, 1 to 32; they take whole bytes.
    explicit RowFilter(unsigned bits);

    /// Forgets all rows and gets ready for so many.
    void reset(std::uint64_t rows);
    /// How many rows it is made for.
    [[nodiscard]] std::uint64_t capacity() const { return capacity_; }
    [[nodiscard]] std::uint64_t size() const { return size_; }
    /// There must be space: size() < capacity().
    void add(std::uint64_t hash);
    [[nodiscard]] bool may_have(std::uint64_t hash) const;
    void prefetch(std::uint64_t hash) const { __builtin_prefetch(bucket(home_of(hash))); }
    [[nodiscard]] std::uint64_t bytes() const { return buckets_ * line; }

private:
    static constexpr std::size_t line = 64;

    /// In the upper half of the hash; what is kept is in the lower one.
    [[nodiscard]] std::uint64_t home_of(std::uint64_t hash) const { return ((hash >> 32U) * buckets_) >> 32U; }
    [[nodiscard]] std::uint8_t* bucket(std::uint64_t number) const {
        return static_cast<std::uint8_t*>(memory_.get()) + number * line;
    }
    template <unsigned bytes>
    [[nodiscard]] bool has(const std::uint8_t* bucket, std::uint32_t wanted, unsigned used) const;

    unsigned bytes_of_row_;
    std::uint32_t mask_;
    unsigned places_;  ///< of a bucket, whose first byte says how many are taken
    lts::Pages memory_;
    std::uint64_t buckets_ = 0;
    std::uint64_t capacity_ = 0;
    std::uint64_t size_ = 0;
};

}  // namespace robochart::refine
