// SPDX-License-Identifier: Apache-2.0
#include "tests/random_models/models/random.hpp"

#include "base/diagnostics/splitmix64.hpp"

namespace robochart::random_models {

std::uint64_t Random::next() {
    return diagnostics::splitmix64(state_);
}

/// The bias of the remainder is below 2^-40 for the small bounds used here.
std::size_t Random::below(std::size_t bound) {
    return static_cast<std::size_t>(next() % bound);
}

}  // namespace robochart::random_models
