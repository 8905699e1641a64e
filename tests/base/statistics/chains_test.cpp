// SPDX-License-Identifier: Apache-2.0
// Compares counts with values by hand, and intervals with Clopper and Pearson's. Checks the coverage.
#include "base/statistics/chains.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

namespace robochart::statistics {
namespace {

TEST(TransitionCounts, TakesAllVisits) {
    TransitionCounts counts(3);
    counts.add({0, 0, 1, 0, 2});  // the end of the sequence has no successor
    counts.add({1, 2});
    counts.add({2});
    EXPECT_EQ(counts.count(0, 0), 1U);
    EXPECT_EQ(counts.count(0, 1), 1U);
    EXPECT_EQ(counts.count(0, 2), 1U);
    EXPECT_EQ(counts.count(1, 0), 1U);
    EXPECT_EQ(counts.count(1, 2), 1U);
    EXPECT_EQ(counts.visit_count(0), 3U);
    EXPECT_EQ(counts.visit_count(1), 2U);
    EXPECT_EQ(counts.visit_count(2), 0U);
    EXPECT_EQ(counts.count_at_last_look(0), 0U) << "the first look is after sixteen";
}

/// The first look is after sixteen visits, the second after twenty-four. Each look needs half as many visits again.
TEST(TransitionCounts, LooksAtFixedNumbers) {
    TransitionCounts counts(2);
    for (int i = 0; i < 20; ++i) counts.add({0, i < 16 ? 0U : 1U});
    EXPECT_EQ(counts.count_at_last_look(0), 16U);
    EXPECT_EQ(counts.count_at_last_look(0, 1), 0U);
    EXPECT_EQ(counts.count(0, 1), 4U);
    for (int i = 0; i < 4; ++i) counts.add({0, 1});
    EXPECT_EQ(counts.count_at_last_look(0), 24U);
    EXPECT_EQ(counts.count_at_last_look(0, 1), 8U);
}

TEST(TransitionIntervals, ErrorIsDividedAndNothingUnseenIsImpossible) {
    TransitionCounts counts(2);
    for (int i = 0; i < 20; ++i) counts.add({0, 0});
    const auto intervals = transition_intervals(counts, all_permitted(2), 0.04);
    // Four transitions share the error, and the first look uses half of each share.
    EXPECT_EQ(intervals[0][0], clopper_pearson(16, 16, 0.005));
    EXPECT_EQ(intervals[0][1], clopper_pearson(0, 16, 0.005));
    EXPECT_GT(intervals[0][1].high, 0);
    EXPECT_EQ(intervals[1][0], (Interval{0, 1}));  // never visited
}

TEST(TransitionIntervals, WhatTheModelForbidsIsExcluded) {
    TransitionCounts counts(2);
    for (int i = 0; i < 20; ++i) counts.add({0, 0});
    const auto intervals = transition_intervals(counts, {{true, false}, {true, true}}, 0.04);
    EXPECT_EQ(intervals[0][0], (Interval{1, 1}));
    EXPECT_EQ(intervals[0][1], (Interval{0, 0}));
    counts.add({0, 1});
    counts.add({1, 1});
    EXPECT_THROW((void)transition_intervals(counts, {{true, false}, {true, true}}, 0.04), std::invalid_argument);
    EXPECT_THROW((void)transition_intervals(counts, {{false, false}, {true, true}}, 0.04), std::invalid_argument);
}

TEST(Validation, CanFail) {
    // With 40 of 100 successes and an error of 0.01, the interval is from 0.276 to 0.534.
    EXPECT_TRUE(contradicts_prediction(40, 100, 0.01, {0.6, 1}));
    EXPECT_TRUE(contradicts_prediction(40, 100, 0.01, {0, 0.2}));
    EXPECT_FALSE(contradicts_prediction(40, 100, 0.01, {0.5, 0.6}));
    EXPECT_FALSE(contradicts_prediction(40, 100, 0.01, {0, 1}));
}

// ---------------------------------------------------------------- the order of a chain

/// Returns random sequences in which the state stays the same with one probability after an equal predecessor, and with
/// another after a different one.
StateSequence remembering(double after_equal, double after_other, std::mt19937_64& random) {
    std::uniform_real_distribution<double> draw(0, 1);
    StateSequence sequence{0, 0};
    while (sequence.size() < 40) {
        const std::size_t last = sequence.back();
        const double stays = last == sequence[sequence.size() - 2] ? after_equal : after_other;
        sequence.push_back(draw(random) < stays ? last : 1 - last);
    }
    return sequence;
}

/// The error is divided among the permitted triples of states, and look k uses 1 / (k (k + 1)) of each part. Only state
/// 2 has two successors, and two states may precede it, so there are four triples. If everything is permitted there are
/// 27.
TEST(Order, DividesTheErrorAmongWhatIsPermitted) {
    const Permitted holes{{false, false, true}, {false, false, true}, {true, true, false}};
    EXPECT_EQ(order_triples(holes), 4);
    EXPECT_EQ(order_triples(all_permitted(3)), 27);
    EXPECT_EQ(order_triples({{false, true}, {true, false}}), 1) << "nothing is open";
    const auto found = [](std::size_t visits, const Permitted& permitted) {
        std::vector<StateSequence> all(visits, {0, 2, 0});
        all.insert(all.end(), visits, {1, 2, 1});
        return order_contradiction(all, permitted, 0.1).value();
    };
    const auto expect = [](const OrderContradiction& seen, std::uint64_t visits, double error) {
        EXPECT_EQ(seen.state, 2U);
        EXPECT_EQ(seen.next, 0U);
        EXPECT_EQ(seen.less, 1U);
        EXPECT_EQ(seen.more, 0U);
        EXPECT_EQ(seen.after_less, clopper_pearson(0, visits, error));
        EXPECT_EQ(seen.after_more, clopper_pearson(visits, visits, error));
    };
    expect(found(16, holes), 16, 0.1 / (4 * 1 * 2));
    expect(found(20, holes), 16, 0.1 / (4 * 1 * 2));
    expect(found(24, holes), 24, 0.1 / (4 * 2 * 3));
    expect(found(16, all_permitted(3)), 16, 0.1 / (27 * 1 * 2));
}

/// The limits of a run apply. If few states occur, the memory does not grow with the cube of the number of states.
TEST(Order, Polls) {
    std::vector<StateSequence> all(200, {0, 2, 0});
    all.insert(all.end(), 200, {1, 2, 1});
    struct CountedPolls final : diagnostics::Pollable {
        void poll() override {
            if (++polls > 2) throw std::runtime_error("limit");
        }
        int polls = 0;
    } budget;
    EXPECT_TRUE(order_contradiction(all, all_permitted(500), 0.1, budget));
    EXPECT_EQ(budget.polls, 2) << "of each successor that was seen";
    EXPECT_THROW((void)order_contradiction(all, all_permitted(3), 0.1, budget), std::runtime_error);
}

/// In 200 repetitions, the test contradicts at most a tenth of the chains of order 1, and all chains of order 2.
TEST(Order, IsContradictedWhereTheStateBeforeMatters) {
    std::mt19937_64 random(7);
    int wrong = 0;
    for (int repetition = 0; repetition < 200; ++repetition) {
        std::vector<StateSequence> first, second;
        for (int i = 0; i < 20; ++i) first.push_back(remembering(0.7, 0.7, random));
        for (int i = 0; i < 20; ++i) second.push_back(remembering(0.9, 0.3, random));
        if (order_contradiction(first, all_permitted(2), 0.1)) ++wrong;
        const auto found = order_contradiction(second, all_permitted(2), 0.1);
        ASSERT_TRUE(found);
        EXPECT_LT(found->after_less.high, found->after_more.low);
        EXPECT_NE(found->less, found->more);
        // The state stays the same more often after an equal predecessor than after a different one.
        EXPECT_EQ(found->more == found->state, found->next == found->state);
    }
    EXPECT_LE(wrong, 20);
}

/// Two pairs with the same middle state need sixteen visits each before an answer.
TEST(Order, IsNotContradictedByFewVisits) {
    const std::vector<StateSequence> few(15, {0, 2, 0});
    std::vector<StateSequence> all = few;
    for (int i = 0; i < 100; ++i) all.push_back({1, 2, 1});
    EXPECT_FALSE(order_contradiction(all, all_permitted(3), 0.1));
    all.push_back({0, 2, 0});
    const auto found = order_contradiction(all, all_permitted(3), 0.1);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->state, 2U);
    EXPECT_FALSE(order_contradiction({}, all_permitted(3), 0.1));
    EXPECT_FALSE(order_contradiction({{0}, {0, 1}}, all_permitted(3), 0.1));
}

}  // namespace
}  // namespace robochart::statistics
