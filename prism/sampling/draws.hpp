// SPDX-License-Identifier: Apache-2.0
// Generates the random numbers of one path: SplitMix64 with a separate increment for each path, which is how the
// authors of SplitMix64 split generators (Steele, Lea, Flood: Fast splittable pseudorandom number generators, OOPSLA
// 2014). So a path depends only on the seed and on its number, and not on the thread that computes it.
#pragma once

#include <cstdint>

#include "base/diagnostics/splitmix64.hpp"

namespace robochart::prism {

class Draws {
public:
    Draws(std::uint64_t seed, std::uint64_t path)
        : state_(diagnostics::splitmix64_mixed(diagnostics::splitmix64_mixed(seed) + path)),
          increment_(diagnostics::splitmix64_mixed(state_ + diagnostics::splitmix64_step) | 1U) {}

    /// Draws the next 64 bits.
    std::uint64_t draw_bits() { return diagnostics::splitmix64_mixed(state_ += increment_); }
    /// Draws a multiple of 2^-53 that is uniform in [0, 1).
    double draw_unit() { return static_cast<double>(draw_bits() >> 11U) * 0x1.0p-53; }
    /// Draws a number that is uniform below `count`, which must not be 0. Rejection sampling avoids a bias.
    std::uint64_t draw_below(std::uint64_t count) {
        const std::uint64_t refused = (0 - count) % count;
        while (true)
            if (const std::uint64_t drawn = draw_bits(); drawn >= refused) return drawn % count;
    }

private:
    std::uint64_t state_, increment_;
};

}  // namespace robochart::prism
