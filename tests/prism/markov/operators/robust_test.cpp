// SPDX-License-Identifier: Apache-2.0
// Tests bounds for chains with uncertain probabilities. They are computed by hand, and compared with each vertex of the
// bounds. The test also checks the coverage of bounds for estimated chains.
#include "prism/markov/operators/robust.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>

#include "base/statistics/chains.hpp"

namespace robochart::markov {
namespace {

/// Returns a chain in which state 0 leads to 1 with a probability between 0.2 and 0.4, and otherwise back to 0.
UncertainChain waiting() {
    return {{{0, 0.6, 0.8}, {1, 0.2, 0.4}}, {{1, 1, 1}}};
}

TEST(Robust, ByHand) {
    const StateSet goal{false, true};
    const auto least = reach_bounds(waiting(), goal, 3, Direction::minimum);
    const auto greatest = reach_bounds(waiting(), goal, 3, Direction::maximum);
    ASSERT_EQ(least.size(), 4U);
    EXPECT_EQ(least[0][0], 0);
    EXPECT_EQ(least[0][1], 1);
    // The values are 1 - 0.8^3 and 1 - 0.6^3, rounded outward.
    EXPECT_NEAR(least[3][0], 0.488, 1e-12);
    EXPECT_LE(least[3][0], 0.488 + 1e-16);
    EXPECT_NEAR(greatest[3][0], 0.784, 1e-12);
    EXPECT_GE(greatest[3][0], 0.784 - 1e-16);
    EXPECT_EQ(greatest[3][1], 1);
}

/// The model of PRISM's manual (The PRISM Language, Uncertain Models): from x=0, [0.8,0.9] to itself and [0.1,0.2] to
/// x=1. Pmin and Pmax of F<=3 x=1 are 1 - 0.9^3 and 1 - 0.8^3. Rmin and Rmax of the steps to x=1 are 1 / 0.2 and 1 /
/// 0.1.
TEST(Robust, TheModelOfPrismsManual) {
    const UncertainChain chain{{{0, 0.8, 0.9}, {1, 0.1, 0.2}}, {{1, 1, 1}}};
    const StateSet goal{false, true};
    EXPECT_NEAR(reach_bounds(chain, goal, 3, Direction::minimum)[3][0], 0.271, 1e-12);
    EXPECT_NEAR(reach_bounds(chain, goal, 3, Direction::maximum)[3][0], 0.488, 1e-12);
    EXPECT_NEAR(cost_bounds(chain, goal, {1, 0}, Direction::minimum)[0], 5, 1e-6);
    const double longest = cost_bounds(chain, goal, {1, 0}, Direction::maximum)[0];
    EXPECT_GE(longest, 10) << "a bound";
    EXPECT_NEAR(longest, 10, 1e-4);
}

/// In interval Markov chains nature chooses again at every visit of a state (as in PRISM's robust verification, which
/// uses interval MDPs). With two steps left, the fast path is better, although it fails with probability one half. With
/// three steps left, the sure path is better. A single chain that takes the sure path with probability l reaches the
/// goal within three steps with probability 0.375 + 0.125 l, which is at most 0.5. Nature reaches it with 0.5 (0.5 0.5)
/// + 0.5.
TEST(Robust, NatureChoosesAnewInEachStep) {
    constexpr State quick = 1, sure = 2, surer = 3, there = 4, lost = 5;
    const UncertainChain chain{
        {{0, 0.5, 0.5}, {quick, 0, 0.5}, {sure, 0, 0.5}},
        {{there, 0.5, 0.5}, {lost, 0.5, 0.5}},
        {{surer, 1, 1}},
        {{there, 1, 1}},
        {{there, 1, 1}},
        {{lost, 1, 1}},
    };
    const StateSet goal{false, false, false, false, true, false};
    const auto most = reach_bounds(chain, goal, 4, Direction::maximum);
    EXPECT_NEAR(most[1][0], 0, 1e-12);
    EXPECT_NEAR(most[2][0], 0.25, 1e-12);
    EXPECT_NEAR(most[3][0], 0.625, 1e-12);
    EXPECT_NEAR(most[4][0], 0.8125, 1e-12);
    // For the minimum, nature takes the fast path with three steps left and the sure path with two.
    EXPECT_NEAR(reach_bounds(chain, goal, 3, Direction::minimum)[3][0], 0.5 * 0 + 0.5 * 0.5, 1e-12);
}

/// After one more step, three successors have the values 1, 0.5 and 0. An upper bound of a branch does not matter if
/// less probability mass remains.
TEST(Robust, MassGoesWhereItCounts) {
    const UncertainChain chain{
        {{1, 0.1, 0.5}, {2, 0.2, 0.6}, {3, 0.1, 0.9}},
        {{1, 1, 1}},
        {{1, 0.5, 0.5}, {3, 0.5, 0.5}},
        {{3, 1, 1}},
    };
    const StateSet goal{false, true, false, false};
    // For the maximum, nature gives 0.5 to the goal, 0.4 to the state of value 0.5, and 0.1 to the state of value 0.
    // For the minimum, it gives them 0.1, 0.2 and 0.7.
    EXPECT_NEAR(reach_bounds(chain, goal, 2, Direction::maximum)[2][0], 0.5 + 0.5 * 0.4, 1e-12);
    EXPECT_NEAR(reach_bounds(chain, goal, 2, Direction::minimum)[2][0], 0.1 + 0.5 * 0.2, 1e-12);
}

TEST(Robust, RowsThatHoldNothingAreRefused) {
    EXPECT_THROW(
        (void)reach_bounds({{{0, 0.6, 0.8}, {1, 0.6, 0.7}}, {{1, 1, 1}}}, {false, true}, 1, Direction::maximum),
        std::invalid_argument);
    EXPECT_THROW((void)reach_bounds({{{0, 0, 0.3}, {1, 0, 0.3}}, {{1, 1, 1}}}, {false, true}, 1, Direction::maximum),
                 std::invalid_argument);
}

TEST(Robust, Values) {
    // After two steps the chain has left with a probability from 1 - 0.8^2 to 1 - 0.6^2.
    const std::vector<double> value{-1, 10};
    EXPECT_NEAR(value_bounds(waiting(), value, 2, Direction::minimum)[2][0], 10 * 0.36 - 0.64, 1e-12);
    EXPECT_NEAR(value_bounds(waiting(), value, 2, Direction::maximum)[2][0], 10 * 0.64 - 0.36, 1e-12);
    EXPECT_EQ(value_bounds(waiting(), value, 2, Direction::maximum)[0][0], -1);
}

/// A geometric time with a probability from 0.2 to 0.4 has a mean from 2.5 to 5 steps.
TEST(Robust, Costs) {
    const StateSet goal{false, true};
    const double least = cost_bounds(waiting(), goal, {2, 7}, Direction::minimum)[0];
    EXPECT_LE(least, 5);
    EXPECT_NEAR(least, 5, 1e-4);
    const double most = cost_bounds(waiting(), goal, {2, 7}, Direction::maximum)[0];
    EXPECT_GE(most, 10);
    EXPECT_NEAR(most, 10, 1e-4);
    EXPECT_EQ(cost_bounds(waiting(), goal, {2, 7}, Direction::maximum)[1], 0);
}

/// An initial state without cost may lead directly to the goal.
TEST(Robust, CostsBehindAStart) {
    const UncertainChain chain{{{1, 0.5, 0.75}, {2, 0.25, 0.5}}, {{1, 0.6, 0.8}, {2, 0.2, 0.4}}, {{2, 1, 1}}};
    const StateSet goal{false, false, true};
    EXPECT_NEAR(cost_bounds(chain, goal, {0, 1, 1}, Direction::minimum)[0], 0.5 * 2.5, 1e-4);
    const double most = cost_bounds(chain, goal, {0, 1, 1}, Direction::maximum)[0];
    EXPECT_GE(most, 0.75 * 5);
    EXPECT_NEAR(most, 0.75 * 5, 1e-4);
}

/// There is no upper bound if nature may stay forever, if it may lead to a state in which it may stay, or if the number
/// of rounds is too small.
TEST(Robust, CostsWithoutBound) {
    const UncertainChain chain{{{0, 0, 0.5}, {1, 0.5, 1}, {2, 0, 0.1}}, {{1, 1, 1}}, {{1, 0, 1}, {2, 0, 1}}};
    const StateSet goal{false, true, false};
    const std::vector<double> cost{1, 1, 1};
    const auto most = cost_bounds(chain, goal, cost, Direction::maximum);
    EXPECT_TRUE(std::isinf(most[0]));
    EXPECT_TRUE(std::isinf(most[2]));
    EXPECT_EQ(most[1], 0);
    EXPECT_NEAR(cost_bounds(chain, goal, cost, Direction::minimum)[0], 1, 1e-6);
    EXPECT_TRUE(std::isinf(cost_bounds(waiting(), {false, true}, {1, 1}, Direction::maximum, 3)[0]));
    // A state that the chain cannot reach does not matter.
    UncertainChain apart = chain;
    apart[0].pop_back();
    EXPECT_NEAR(cost_bounds(apart, goal, cost, Direction::maximum)[0], 2, 1e-4);
}

/// The chain leaves its state with a probability a from 0.2 to 0.4, and returns with 0.5. So it is away for a / (a +
/// 0.5) of the time. With a period it is away for half of that.
TEST(Robust, Averages) {
    const UncertainChain chain{{{0, 0.6, 0.8}, {1, 0.2, 0.4}}, {{0, 0.5, 0.5}, {1, 0.5, 0.5}}};
    const double least = average_bound(chain, 0, {0, 1}, Direction::minimum);
    const double most = average_bound(chain, 0, {0, 1}, Direction::maximum);
    EXPECT_LE(least, 0.2 / 0.7 + 1e-15);
    EXPECT_NEAR(least, 0.2 / 0.7, 1e-7);
    EXPECT_GE(most, 0.4 / 0.9 - 1e-15);
    EXPECT_NEAR(most, 0.4 / 0.9, 1e-7);
    const UncertainChain swings{{{1, 1, 1}}, {{0, 1, 1}}, {{2, 1, 1}}};
    EXPECT_NEAR(average_bound(swings, 0, {0, 1, 9}, Direction::maximum), 0.5, 1e-7) << "2 is not reached";
    EXPECT_NEAR(average_bound(swings, 0, {0, 1, 9}, Direction::minimum), 0.5, 1e-7);
    EXPECT_GE(average_bound(chain, 0, {0, 1}, Direction::maximum, 1), 0.4 / 0.9) << "one round gives a bound too";
}

// ---------------------------------------------------------------- a swarm that can be lumped

/// Robots search and carry independently, so the number of carrying robots is a Markov chain.
constexpr std::size_t robots = 3;
constexpr double finds = 0.15;
constexpr double drops = 0.25;
constexpr std::size_t horizon = 12;

std::size_t carrying_count(unsigned swarm) {
    return static_cast<std::size_t>(__builtin_popcount(swarm));
}

statistics::StateSequence run(std::mt19937_64& random) {
    std::uniform_real_distribution<double> draw(0, 1);
    unsigned swarm = 0;
    statistics::StateSequence seen{0};
    for (std::size_t step = 0; step < horizon; ++step) {
        for (unsigned robot = 0; robot < robots; ++robot) {
            const unsigned bit = 1U << robot;
            const double chance = (swarm & bit) != 0 ? drops : finds;
            if (draw(random) < chance) swarm ^= bit;
        }
        seen.push_back(carrying_count(swarm));
    }
    return seen;
}

/// Returns the probability that all robots carry at some time up to each step. It is computed with the eight states of
/// the individual robots.
std::array<double, horizon + 1> truth() {
    std::array<double, 8> now{1};
    std::array<double, horizon + 1> result{};
    for (std::size_t step = 1; step <= horizon; ++step) {
        std::array<double, 8> next{};
        for (unsigned from = 0; from < 8; ++from)
            for (unsigned to = 0; to < 8; ++to) {
                double chance = from == 7 && to != 7 ? 0 : 1;  // the goal is absorbing
                for (unsigned robot = 0; robot < robots && from != 7; ++robot) {
                    const unsigned bit = 1U << robot;
                    const double turns = (from & bit) != 0 ? drops : finds;
                    chance *= ((from ^ to) & bit) != 0 ? turns : 1 - turns;
                }
                next[to] += now[from] * chance;
            }
        now = next;
        result[step] = now[7];
    }
    return result;
}

UncertainChain chain_of_intervals(const std::vector<std::vector<statistics::Interval>>& intervals) {
    UncertainChain chain;
    for (const auto& row : intervals) {
        UncertainRow& added = chain.emplace_back();
        for (State to = 0; to < row.size(); ++to) added.push_back({to, row[to].low, row[to].high});
    }
    return chain;
}

bool covers(const UncertainChain& chain) {
    const StateSet goal{false, false, false, true};
    const auto least = reach_bounds(chain, goal, horizon, Direction::minimum);
    const auto greatest = reach_bounds(chain, goal, horizon, Direction::maximum);
    const auto exact = truth();
    for (std::size_t step = 0; step <= horizon; ++step)
        if (exact[step] < least[step][0] - 1e-12 || exact[step] > greatest[step][0] + 1e-12) return false;
    return true;
}

/// The bounds of an estimated chain must contain the truth in at least 19 of 20 repetitions. They must also be narrow,
/// because wide bounds hold for any chain.
TEST(Robust, BoundsOfEstimatedChainsHoldInNineteenOfTwentyRepetitions) {
    constexpr int repetitions = 200;
    int intervals = 0;
    double widest = 0;
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        std::mt19937_64 random(static_cast<std::uint64_t>(repetition) + 1);
        statistics::TransitionCounts counts(robots + 1);
        for (int trial = 0; trial < 500; ++trial) counts.add(run(random));
        const UncertainChain chain =
            chain_of_intervals(statistics::transition_intervals(counts, statistics::all_permitted(robots + 1), 0.05));
        if (covers(chain)) ++intervals;
        const StateSet goal{false, false, false, true};
        widest = std::max(widest, reach_bounds(chain, goal, horizon, Direction::maximum)[horizon][0] -
                                      reach_bounds(chain, goal, horizon, Direction::minimum)[horizon][0]);
    }
    EXPECT_GE(intervals, 190);
    EXPECT_LT(widest, 0.5);
}

/// These swarms are locked forever in the initial state with probability 0.6, and otherwise leave it with probability
/// one half in each step. Their behaviour depends on more than the state. The estimated chain leaves at the average
/// rate of all swarms, but fresh trials leave soon or never.
TEST(Robust, ChainThatHidesLockedRunsIsRefuted) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> draw(0, 1);
    const auto trial = [&] {
        const bool locked = draw(random) < 0.6;
        statistics::StateSequence seen{0};
        for (std::size_t step = 0; step < horizon; ++step)
            seen.push_back(seen.back() == 1 || (!locked && draw(random) < 0.5) ? 1 : 0);
        return seen;
    };
    statistics::TransitionCounts counts(2);
    for (int i = 0; i < 400; ++i) counts.add(trial());
    const UncertainChain chain =
        chain_of_intervals(statistics::transition_intervals(counts, {{true, true}, {false, true}}, 0.01));
    const auto least = reach_bounds(chain, {false, true}, horizon, Direction::minimum);
    const auto greatest = reach_bounds(chain, {false, true}, horizon, Direction::maximum);
    std::array<std::uint64_t, horizon + 1> left{};
    constexpr std::uint64_t fresh = 400;
    for (std::uint64_t i = 0; i < fresh; ++i) {
        const statistics::StateSequence seen = trial();
        for (std::size_t step = 0; step <= horizon; ++step) left[step] += seen[step];
    }
    const auto refuted = [&](std::size_t step) {
        return statistics::contradicts_prediction(left[step], fresh, 0.01 / horizon,
                                                  {least[step][0], greatest[step][0]});
    };
    // One swarm in five leaves in the first step. Only one visit in twenty is the last one, because most visits are
    // those of locked swarms.
    EXPECT_TRUE(refuted(1));
}

}  // namespace
}  // namespace robochart::markov
