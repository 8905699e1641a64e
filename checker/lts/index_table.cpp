// SPDX-License-Identifier: Apache-2.0
#include "checker/lts/index_table.hpp"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace robochart::lts {

void IndexTable::reset_for_capacity(std::uint64_t numbers) {
    std::uint64_t buckets = bucket_count_;
    while (buckets * bucket_size * 4 / 5 < numbers) buckets = std::max(buckets + 1, buckets * 3 / 2);
    if (buckets > no_state - 64) throw std::length_error("more than 2^32 states");
    reset(static_cast<std::uint32_t>(buckets));
}

/// Frees the old memory before it allocates the new memory, so that only one table exists at a time.
void IndexTable::reset(std::uint32_t bucket_count) {
    assert(bucket_count > 0);
    bucket_count_ = bucket_count;
    memory_.reset();
    memory_ = zeroed_pages(std::size_t{bucket_count_} * sizeof(Bucket));
    assert(reinterpret_cast<std::uintptr_t>(memory_.get()) % alignof(Bucket) == 0);
}

}  // namespace robochart::lts
