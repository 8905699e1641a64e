// Random numbers of one path: SplitMix64 with an increment of its own for every path, as its authors split generators
// (Steele, Lea, Flood: Fast splittable pseudorandom number generators, OOPSLA 2014). So a path depends on the seed and
// its number alone, and not on the thread that follows it.
#pragma once

#include <cstdint>

#include "diagnostics/splitmix64.hpp"

namespace robochart::prism {

class Draws {
public:
    Draws(std::uint64_t seed, std::uint64_t path)
        : state_(diagnostics::splitmix64_mixed(diagnostics::splitmix64_mixed(seed) + path)),
          increment_(diagnostics::splitmix64_mixed(state_ + diagnostics::splitmix64_step) | 1U) {}

    /// The next 64 bits.
    std::uint64_t next() { return diagnostics::splitmix64_mixed(state_ += increment_); }
    /// Uniform in [0, 1), a multiple of 2^-53.
    double unit() { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }
    /// Uniform below a count that is not 0: what would make some numbers likelier is drawn again.
    std::uint64_t below(std::uint64_t count) {
        const std::uint64_t refused = (0 - count) % count;
        while (true)
            if (const std::uint64_t drawn = next(); drawn >= refused) return drawn % count;
    }

private:
    std::uint64_t state_, increment_;
};

}  // namespace robochart::prism
