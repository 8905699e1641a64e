// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/levels/row_filter.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace robochart::refine {
namespace {

constexpr std::size_t counts_size = sizeof(std::uint64_t);
/// If the expected number of mistaken rows is less than this, mistakes are negligible.
constexpr double fewest_errors = 0.25;
constexpr std::uint64_t full = std::uint64_t{1} << 63U;

}  // namespace

RowFilter::RowFilter(unsigned most_bits, std::uint64_t most_bytes) : most_bits_(most_bits), most_bytes_(most_bytes) {
    if (most_bits == 0 || most_bits > 32) throw std::logic_error("a filter has 1 to 32 bits a row");
    reset(0);
}

/// Sets the number of bits that are stored of each row, which take whole bytes. When a bucket is full, the counts of
/// the rows in its parts take all bits of a word except the top one.
void RowFilter::keep_bits(unsigned bits) {
    assert(bits >= 1 && bits <= 32);
    bytes_of_row_ = (bits + 7) / 8;
    mask_ = bits >= 32 ? 0xFFFFFFFFU : (std::uint32_t{1} << bits) - 1;
    places_ = static_cast<unsigned>(line - counts_size) / bytes_of_row_;
    parts_ = 63 - places_;
    assert(places_ > 0 && places_ < 63 && counts_size + std::size_t{places_} * bytes_of_row_ <= line);
}

/// Allocates space for twice as many rows as there are, so that a growing filter is seldom refilled. If this takes more
/// than a quarter of the memory limit, allocates all of the limit. The space must suffice for at least an eighth more
/// rows than there are.
void RowFilter::reset(std::uint64_t rows) {
    constexpr std::uint64_t fewest = 4096;
    size_ = 0;
    full_ = 0;
    capacity_ = 0;
    buckets_ = 0;
    memory_.reset();
    for (keep_bits(most_bits_);; keep_bits(8 * (bytes_of_row_ - 1))) {
        const std::uint64_t most = most_bytes_ / line;
        const std::uint64_t needed = std::max(fewest, 2 * rows) * 20 / (std::uint64_t{places_} * 19) + 1;
        const std::uint64_t buckets = needed > most / 4 ? most : needed;
        const bool fits = buckets > 0 && space_in(buckets) >= rows + rows / 8 + 1;
        // With fewer bits, the filter has space for more rows, so it is refilled less often.
        const bool fewer = bytes_of_row_ > 1 && errors_with(8 * (bytes_of_row_ - 1), buckets) < fewest_errors;
        if (fits && !fewer) {
            buckets_ = buckets;
            break;
        }
        if (bytes_of_row_ == 1) return;
    }
    capacity_ = space_in(buckets_);
    // The additional word is needed because the filter always reads the same number of bytes for a row.
    memory_ = lts::zeroed_pages(buckets_ * line + sizeof(std::uint32_t));
}

/// Returns the approximate number of rows that are mistaken for duplicates while the filter is filled, if it stores
/// this many bits of each row.
double RowFilter::errors_with(unsigned bits, std::uint64_t buckets) {
    const double places = static_cast<double>(line - counts_size) / (bits / 8);
    const double compared = places / (63 - places);
    return static_cast<double>(buckets) * places * compared / std::exp2(bits);
}

/// Computes the probability that the filter accepts a row that was not added. A look-up examines buckets up to the
/// first that is not full. In each bucket it compares the row with the rows of one part.
double RowFilter::error() const {
    if (full_ == buckets_) return 1;
    const double compared = static_cast<double>(size_) / (static_cast<double>(buckets_ - full_) * parts_);
    return std::min(1.0, compared / (static_cast<double>(mask_) + 1));
}

namespace {

std::uint64_t counts_of(const std::uint8_t* bucket) {
    std::uint64_t counts = 0;
    std::memcpy(&counts, bucket, sizeof counts);
    return counts;
}

constexpr std::uint64_t ones = 0x0101010101010101U, tops = 0x8080808080808080U;

/// Returns, for each byte, the number of bits set in this byte and in the lower ones.
std::uint64_t sums_of(std::uint64_t word) {
    word -= (word >> 1U) & 0x5555555555555555U;
    word = (word & 0x3333333333333333U) + ((word >> 2U) & 0x3333333333333333U);
    return ((word + (word >> 4U)) & 0x0F0F0F0F0F0F0F0FU) * ones;
}

/// Returns the index of the zero that follows this many zeros. This zero must exist. (Vigna, Broadword implementation
/// of rank/select queries, WEA 2008.)
unsigned zero_after(std::uint64_t word, unsigned zeros) {
    const std::uint64_t sums = sums_of(~word);
    const std::uint64_t passed = (((zeros * ones) | tops) - sums) & tops;
    const auto byte = static_cast<unsigned>((passed >> 7U) * ones >> 56U) * 8;
    std::uint64_t rest = ~word >> byte;
    for (auto before = static_cast<unsigned>(sums << 8U >> byte & 0xFFU); before < zeros; ++before) rest &= rest - 1;
    return byte + static_cast<unsigned>(std::countr_zero(rest));
}

}  // namespace

void RowFilter::add(std::uint64_t hash) {
    const unsigned part = part_of(hash);
    std::uint64_t home = home_of(hash);
    std::uint64_t counts = counts_of(bucket(home));
    while ((counts & full) != 0) {
        home = home + 1 == buckets_ ? 0 : home + 1;
        counts = counts_of(bucket(home));
    }
    std::uint8_t* const at = bucket(home);
    const unsigned zero = zero_after(counts, part);
    std::uint8_t* const place = at + counts_size + std::size_t{zero - part} * bytes_of_row_;
    const auto used = static_cast<unsigned>(sums_of(counts) >> 56U);
    std::memmove(place + bytes_of_row_, place, std::size_t{used + part - zero} * bytes_of_row_);
    const auto bits = static_cast<std::uint32_t>(hash) & mask_;
    std::memcpy(place, &bits, bytes_of_row_);
    const std::uint64_t below = (std::uint64_t{1} << zero) - 1;
    counts = (counts & below) | std::uint64_t{1} << zero | (counts & ~below) << 1U;
    if (used + 1 == places_) {
        counts |= full;
        ++full_;
    }
    std::memcpy(at, &counts, sizeof counts);
    ++size_;
}

/// Returns true if the part of the bucket contains a row with these bits. The rows of a part are stored before the zero
/// of the part.
bool RowFilter::bucket_contains(const std::uint8_t* bucket, std::uint64_t counts, unsigned part,
                                std::uint32_t bits) const {
    unsigned zero = zero_after(counts, part);
    for (const std::uint8_t* at = bucket + counts_size + std::size_t{zero - part} * bytes_of_row_;
         zero > 0 && (counts >> (zero - 1) & 1U) != 0; --zero) {
        at -= bytes_of_row_;
        std::uint32_t stored = 0;
        std::memcpy(&stored, at, sizeof stored);
        if ((stored & mask_) == bits) return true;
    }
    return false;
}

bool RowFilter::may_have(std::uint64_t hash) const {
    if (buckets_ == 0) return true;
    const auto bits = static_cast<std::uint32_t>(hash) & mask_;
    const unsigned part = part_of(hash);
    for (std::uint64_t home = home_of(hash), tried = 0; tried < buckets_; ++tried) {
        const std::uint8_t* const at = bucket(home);
        const std::uint64_t counts = counts_of(at);
        if (bucket_contains(at, counts, part, bits)) return true;
        if ((counts & full) == 0) return false;
        home = home + 1 == buckets_ ? 0 : home + 1;
    }
    return false;
}

}  // namespace robochart::refine
