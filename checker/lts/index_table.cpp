#include "checker/lts/index_table.hpp"

#include <algorithm>
#include <stdexcept>

namespace robochart::lts {
namespace {

constexpr std::uint32_t most_segments = 64;
/// Below this a segment might fill up while the table as a whole has room.
constexpr std::uint32_t least_segment = 1024;

}  // namespace

void IndexTable::grow(std::uint64_t numbers) {
    std::uint64_t wanted = bucket_count_;
    while (wanted * bucket_size * 4 / 5 < numbers) wanted = std::max(wanted + 1, wanted * 3 / 2);
    if (wanted > no_state) throw std::length_error("more than 2^32 states");
    reset(static_cast<std::uint32_t>(wanted));
}

/// The old memory goes before the new one comes: there is never both.
void IndexTable::reset(std::uint32_t bucket_count) {
    const bool divided = bucket_count >= most_segments * least_segment;
    const std::uint32_t rest = divided ? bucket_count % most_segments : 0;
    bucket_count_ = rest == 0 ? bucket_count : bucket_count + most_segments - rest;
    segment_length_ = divided ? bucket_count_ / most_segments : bucket_count_;
    memory_.reset();
    memory_ = zeroed_pages(std::size_t{bucket_count_} * sizeof(Bucket));
}

}  // namespace robochart::lts
