// Random cases one after another, the same for the same seed on every compiler; the seed and the number of checks come
// from the environment (docs/testing.md).
#pragma once

#include <cstdint>
#include <random>

#include "questions.hpp"

namespace robochart::refine {

inline constexpr std::size_t largest_graph = 120;

class RandomCases {
public:
    /// `purpose` sets one test's cases apart from another's.
    explicit RandomCases(std::uint64_t purpose);

    /// A case that the naive checker can explore, with its graphs.
    struct Explored {
        Case asked;
        Graphs graphs;
    };
    Explored next();

private:
    Case random_case();
    std::mt19937_64 numbers_;
};

/// ROBOCHART_RANDOM_CHECKS, or the number given.
[[nodiscard]] int wanted_checks(int otherwise);
/// ROBOCHART_RANDOM_SCRIPTS, or the number given.
[[nodiscard]] int wanted_scripts(int otherwise);

}  // namespace robochart::refine
