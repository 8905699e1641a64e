#include "checker/refine/levels/row_filter.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace robochart::refine {

RowFilter::RowFilter(unsigned most_bits, std::uint64_t most_bytes) : most_bits_(most_bits), most_bytes_(most_bytes) {
    if (most_bits == 0 || most_bits > 32) throw std::logic_error("a filter has 1 to 32 bits a row");
    reset(0);
}

/// They take whole bytes.
void RowFilter::keep_bits(unsigned bits) {
    bytes_of_row_ = (bits + 7) / 8;
    mask_ = bits >= 32 ? 0xFFFFFFFFU : (std::uint32_t{1} << bits) - 1;
    places_ = static_cast<unsigned>(line - 1) / bytes_of_row_;
}

/// Twice as many rows as there are, so that a filter that grows is filled anew seldom; where memory is short, an eighth
/// more at least.
void RowFilter::reset(std::uint64_t rows) {
    constexpr std::uint64_t fewest = 4096;
    size_ = 0;
    capacity_ = 0;
    buckets_ = 0;
    memory_.reset();
    for (keep_bits(most_bits_);; keep_bits(8 * (bytes_of_row_ - 1))) {
        const std::uint64_t most = most_bytes_ / line;
        const std::uint64_t wanted = std::max(fewest, 2 * rows) * 10 / (std::uint64_t{places_} * 9) + 1;
        const std::uint64_t buckets = std::min(most, wanted);
        if (buckets > 0 && space_in(buckets) >= rows + rows / 8 + 1) {
            buckets_ = buckets;
            break;
        }
        if (bytes_of_row_ == 1) return;
    }
    capacity_ = space_in(buckets_);
    memory_ = lts::zeroed_pages(buckets_ * line);
}

double RowFilter::error() const {
    if (buckets_ == 0) return 1;
    const double compared = static_cast<double>(size_) / static_cast<double>(buckets_);
    return std::min(1.0, compared / static_cast<double>(std::uint64_t{mask_} + 1));
}

void RowFilter::add(std::uint64_t hash) {
    std::uint64_t home = home_of(hash);
    while (*bucket(home) == places_) home = home + 1 == buckets_ ? 0 : home + 1;
    std::uint8_t* const at = bucket(home);
    const auto kept = static_cast<std::uint32_t>(hash) & mask_;
    std::memcpy(at + 1 + std::size_t{*at} * bytes_of_row_, &kept, bytes_of_row_);
    ++*at;
    ++size_;
}

template <unsigned bytes>
bool RowFilter::has(const std::uint8_t* bucket, std::uint32_t wanted, unsigned used) const {
    bool found = false;
    for (unsigned i = 0; i < used; ++i) {
        std::uint32_t kept = 0;
        std::memcpy(&kept, bucket + 1 + std::size_t{i} * bytes, bytes);
        found |= kept == wanted;
    }
    return found;
}

bool RowFilter::may_have(std::uint64_t hash) const {
    if (buckets_ == 0) return true;
    const auto wanted = static_cast<std::uint32_t>(hash) & mask_;
    for (std::uint64_t home = home_of(hash), tried = 0; tried < buckets_; ++tried) {
        const std::uint8_t* const at = bucket(home);
        const unsigned used = *at;
        bool found = false;
        switch (bytes_of_row_) {
            case 1:
                found = has<1>(at, wanted, used);
                break;
            case 2:
                found = has<2>(at, wanted, used);
                break;
            case 3:
                found = has<3>(at, wanted, used);
                break;
            default:
                found = has<4>(at, wanted, used);
        }
        if (found) return true;
        if (used < places_) return false;
        home = home + 1 == buckets_ ? 0 : home + 1;
    }
    return false;
}

}  // namespace robochart::refine
