// How many seeds a property is tried with: few by default, ROBOCHART_SEEDS=N for a long run by hand.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/rounds.hpp"

namespace robochart::random_models {

/// Whether ROBOCHART_SEEDS asks for a long run: then nothing is left out.
inline bool is_long_run() {
    return std::getenv("ROBOCHART_SEEDS") != nullptr;
}

/// The seeds from `first` on; as many as asked for (fewer under AddressSanitizer), or as ROBOCHART_SEEDS says, from
/// ROBOCHART_FIRST_SEED on.
inline std::vector<std::uint64_t> seeds(std::uint64_t count, std::uint64_t first = 0) {
    const char* wanted = std::getenv("ROBOCHART_SEEDS");
    const char* from = std::getenv("ROBOCHART_FIRST_SEED");
    if (from != nullptr) first = std::stoull(from);
    count = wanted != nullptr ? std::stoull(wanted) : tests::rounds(count);
    std::vector<std::uint64_t> result;
    for (std::uint64_t i = 0; i < count; ++i) result.push_back(first + i);
    return result;
}

}  // namespace robochart::random_models
