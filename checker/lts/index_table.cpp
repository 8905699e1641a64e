#include "checker/lts/index_table.hpp"

#include <algorithm>
#include <stdexcept>

namespace robochart::lts {
namespace {

/// Shorter segments might fill up while the table as a whole has room.
constexpr std::uint32_t least_segment = 256;

std::uint32_t segments_of(std::uint32_t buckets) {
    for (const std::uint32_t segments : {IndexTable::most_segments, 8U})
        if (buckets >= segments * least_segment) return segments;
    return 1;
}

}  // namespace

void IndexTable::grow(std::uint64_t numbers) {
    std::uint64_t wanted = bucket_count_;
    while (wanted * bucket_size * 4 / 5 < numbers) wanted = std::max(wanted + 1, wanted * 3 / 2);
    if (wanted > no_state - 64) throw std::length_error("more than 2^32 states");
    reset(static_cast<std::uint32_t>(wanted));
}

/// The old memory goes before the new one comes: there is never both.
void IndexTable::reset(std::uint32_t bucket_count) {
    segments_ = segments_of(bucket_count);
    segment_length_ = (bucket_count + segments_ - 1) / segments_;
    bucket_count_ = segment_length_ * segments_;
    memory_.reset();
    memory_ = zeroed_pages(std::size_t{bucket_count_} * sizeof(Bucket));
}

}  // namespace robochart::lts
