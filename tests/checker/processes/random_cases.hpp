// SPDX-License-Identifier: Apache-2.0
// Generates a sequence of random cases that depends only on the seed, not on the compiler. The seed and the number of
// checks come from the environment (docs/testing.md).
#pragma once

#include <cstdint>
#include <random>

#include "questions.hpp"

namespace robochart::refine {

inline constexpr std::size_t largest_graph = 120;

class RandomCases {
public:
    /// Tests with different values of `purpose` get different sequences.
    explicit RandomCases(std::uint64_t purpose);

    /// A case that is small enough for the naive checker, with its graphs.
    struct Explored {
        Case test_case;
        Graphs graphs;
    };
    Explored next();

private:
    Case random_case();
    std::mt19937_64 numbers_;
};

/// Returns ROBOCHART_RANDOM_CHECKS, or `otherwise` if it is not set.
[[nodiscard]] int wanted_checks(int otherwise);
/// Returns ROBOCHART_RANDOM_SCRIPTS, or `otherwise` if it is not set.
[[nodiscard]] int wanted_scripts(int otherwise);

}  // namespace robochart::refine
