// SPDX-License-Identifier: Apache-2.0
// Generates pseudorandom numbers by SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators,
// OOPSLA 2014), the same numbers on every platform.
#pragma once

#include <cstdint>

namespace robochart::diagnostics {

/// Each number increases the state by this: 2^64 divided by the golden ratio, made odd.
inline constexpr std::uint64_t splitmix64_step = 0x9e3779b97f4a7c15U;

/// Returns the number for a state. This is a bijection on 64 bits in which each bit depends on all others.
[[nodiscard]] constexpr std::uint64_t splitmix64_mixed(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
}

/// Advances the state and returns the next number.
constexpr std::uint64_t splitmix64(std::uint64_t& state) {
    return splitmix64_mixed(state += splitmix64_step);
}

}  // namespace robochart::diagnostics
