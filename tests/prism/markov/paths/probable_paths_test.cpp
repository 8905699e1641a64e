// SPDX-License-Identifier: Apache-2.0
// Compares the most probable paths with all paths by definition.
#include "prism/markov/paths/probable_paths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/prism/markov/models/naive.hpp"
#include "tests/prism/markov/models/random_description.hpp"

namespace robochart::markov {
namespace {

/// Returns the first choice of each state.
std::vector<std::uint32_t> first_choices(const Model& model) {
    return {model.first_choice.begin(), model.first_choice.end() - 1};
}

PathSet paths(const Description& description, std::optional<std::uint64_t> steps, double bound, bool strict = true,
              State from = 0) {
    const Model model = model_of(description);
    const Graph graph(model);
    const std::vector<std::uint32_t> strategy = first_choices(model);
    return probable_paths(
        {graph, strategy, description.left, description.right, from, steps, bound, strict, 1'000'000'000, nullptr});
}

/// Returns a chain. State 0 goes to 1 with probability 1/2, to 2 with 1/4, or stays. State 1 goes to 2.
Description small() {
    Description result = dtmc({{{0, 1}, {1, 2}, {2, 1}}, {{2, 1}}, {{2, 1}}});
    result.left = set_of(3, {0, 1});
    result.right = set_of(3, {2});
    return result;
}

TEST(ProbablePaths, ComeInTheOrderOfTheirProbability) {
    const PathSet found = paths(small(), {}, 0.9);
    // The path 0 1 2 has probability 1/2, and 0 2 has 1/4. With one more 0 at the start they have 1/8 and 1/16. The sum
    // 1/2 + 1/4 + 1/8 + 1/16 is above 0.9.
    ASSERT_EQ(found.paths.size(), 4U);
    EXPECT_TRUE(found.enough);
    EXPECT_EQ(found.paths[0].states, (std::vector<State>{0, 1, 2}));
    EXPECT_EQ(found.paths[1].states, (std::vector<State>{0, 2}));
    EXPECT_EQ(found.paths[2].states, (std::vector<State>{0, 0, 1, 2}));
    EXPECT_EQ(found.paths[3].states, (std::vector<State>{0, 0, 2}));
    EXPECT_EQ(found.total, (Enclosure{0.9375, 0.9375}));
}

TEST(ProbablePaths, ABoundIsReachedOrExceeded) {
    EXPECT_EQ(paths(small(), {}, 0.5, false).paths.size(), 1U);
    EXPECT_EQ(paths(small(), {}, 0.5, true).paths.size(), 2U);
}

TEST(ProbablePaths, OfAStateInTheGoalThereIsOneWithoutSteps) {
    const PathSet found = paths(small(), {}, 0.5, true, 2);
    ASSERT_EQ(found.paths.size(), 1U);
    EXPECT_EQ(found.paths[0].states, (std::vector<State>{2}));
    EXPECT_EQ(found.total, (Enclosure{1, 1}));
}

TEST(ProbablePaths, LoopsThatCostNothingAreNoTrap) {
    // States 0 and 1 lead to each other. With probability 1/1000 a step from 1 ends in 2.
    Description description = dtmc({{{1, 1}}, {{0, 999}, {2, 1}}, {{2, 1}}});
    description.left = set_of(3, {0, 1});
    description.right = set_of(3, {2});
    const PathSet found = paths(description, {}, 0.0025);
    EXPECT_TRUE(found.enough);
    EXPECT_EQ(found.paths.size(), 3U);
}

/// With a step bound there are finitely many paths. Each path to a target is found exactly once, and together they have
/// the probability of the definition.
TEST(ProbablePaths, AllPathsTogetherHaveTheProbability) {
    std::mt19937_64 numbers(17);
    for (int i = 0; i < 200; ++i) {
        const Description description = random_description(numbers, Kind::dtmc, {5, 1, 3, false});
        const PathSet found = paths(description, 6, 2);
        EXPECT_FALSE(found.enough);
        const Rational exact = naive::bounded_until(description, 0, 0, 6, Direction::maximum);
        EXPECT_LE(Rational(found.total.low), exact) << description_text(description);
        // Paths with a probability below 1e-9 are omitted if a thousand million of them could not reach the bound.
        EXPECT_GE(Rational(found.total.high + 1e-6), exact) << description_text(description);
        EXPECT_LE(found.total.high - found.total.low, 1e-12);
        std::set<std::vector<State>> different;
        for (std::size_t j = 0; j < found.paths.size(); ++j) {
            const Path& path = found.paths[j];
            EXPECT_TRUE(different.insert(path.states).second);
            EXPECT_TRUE(description.right[path.states.back()]);
            for (std::size_t k = 0; k + 1 < path.states.size(); ++k)
                EXPECT_TRUE(description.left[path.states[k]] && !description.right[path.states[k]]);
            const double before = j == 0 ? 1 : found.paths[j - 1].probability.high;
            EXPECT_LE(path.probability.low, before * (1 + 1e-12));
        }
    }
}

}  // namespace
}  // namespace robochart::markov
