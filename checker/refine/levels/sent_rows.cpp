// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/levels/sent_rows.hpp"

namespace robochart::refine {

void SentRows::resize_to_fit(std::uint64_t most_bytes) {
    constexpr std::uint64_t cached_bytes = std::uint64_t{1} << 18U;
    const std::uint64_t places = std::min(most_bytes, cached_bytes) / ((width_ + 1) * sizeof(lts::Word));
    if (places < 2 * std::max<std::uint64_t>(places_, 1)) return;
    places_ = std::bit_floor(places);
    words_.assign(places_ * (width_ + 1), 0);
}

}  // namespace robochart::refine
