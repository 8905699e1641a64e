// How many seeds a property is tried with: few by default, ROBOCHART_SEEDS=N for a long run by hand.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace robochart::random_models {

/// The seeds from `first` on; as many as asked for, or as ROBOCHART_SEEDS says, from ROBOCHART_FIRST_SEED on.
inline std::vector<std::uint64_t> seeds(std::uint64_t count, std::uint64_t first = 0) {
    const char* wanted = std::getenv("ROBOCHART_SEEDS");
    const char* from = std::getenv("ROBOCHART_FIRST_SEED");
    if (from != nullptr) first = std::stoull(from);
    if (wanted != nullptr) count = std::stoull(wanted);
    std::vector<std::uint64_t> result;
    for (std::uint64_t i = 0; i < count; ++i) result.push_back(first + i);
    return result;
}

}  // namespace robochart::random_models
