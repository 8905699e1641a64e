// SPDX-License-Identifier: Apache-2.0
// Generates the pseudo-random numbers of a trial: xoshiro256++ 1.0 (Blackman, Vigna: "Scrambled linear pseudorandom
// number generators", ACM TOMS 47, 2021). SplitMix64 (Steele, Lea, Flood, OOPSLA 2014) fills the state from the seed,
// as the authors of xoshiro256++ recommend. The same seed gives the same numbers on every machine.
#pragma once

#include <array>
#include <cstdint>

namespace robochart::simulation {

class Random {
public:
    explicit Random(std::uint64_t seed);

    /// Draws the next 64 bits.
    std::uint64_t next();
    /// Draws a multiple of 2^-53 that is uniform in [0, 1).
    double uniform() { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    /// Draws a number that is approximately normal, with mean 0 and standard deviation 1. It is the sum of twelve
    /// uniform numbers, so no function of libm is needed.
    double normal();
    /// True with the given probability. Draws no number for 0 and 1.
    bool draw_chance(double probability);

private:
    std::array<std::uint64_t, 4> state_;
};

}  // namespace robochart::simulation
