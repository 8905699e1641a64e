// SPDX-License-Identifier: Apache-2.0
// Selects the seeds for each property: few by default, or more with ROBOCHART_SEEDS=N for a long run by hand.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/rounds.hpp"

namespace robochart::random_models {

/// Returns whether ROBOCHART_SEEDS requests a long run, which omits nothing.
inline bool is_long_run() {
    return std::getenv("ROBOCHART_SEEDS") != nullptr;
}

/// Returns `count` seeds from `first` on (fewer under AddressSanitizer), or ROBOCHART_SEEDS seeds from
/// ROBOCHART_FIRST_SEED on.
inline std::vector<std::uint64_t> seeds(std::uint64_t count, std::uint64_t first = 0) {
    const char* setting = std::getenv("ROBOCHART_SEEDS");
    const char* from = std::getenv("ROBOCHART_FIRST_SEED");
    if (from != nullptr) first = std::stoull(from);
    count = setting != nullptr ? std::stoull(setting) : tests::rounds(count);
    std::vector<std::uint64_t> result;
    for (std::uint64_t i = 0; i < count; ++i) result.push_back(first + i);
    return result;
}

}  // namespace robochart::random_models
