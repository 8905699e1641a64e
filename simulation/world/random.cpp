// SPDX-License-Identifier: Apache-2.0
#include "simulation/world/random.hpp"

#include <bit>

#include "base/diagnostics/splitmix64.hpp"

namespace robochart::simulation {

Random::Random(std::uint64_t seed) : state_{} {
    for (std::uint64_t& word : state_) word = diagnostics::splitmix64(seed);
}

std::uint64_t Random::next() {
    const std::uint64_t result = std::rotl(state_[0] + state_[3], 23) + state_[0];
    const std::uint64_t shifted = state_[1] << 17U;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = std::rotl(state_[3], 45);
    return result;
}

double Random::normal() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
}

bool Random::draw_chance(double probability) {
    if (probability <= 0) return false;
    return probability >= 1 || uniform() < probability;
}

}  // namespace robochart::simulation
