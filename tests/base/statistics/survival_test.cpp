// SPDX-License-Identifier: Apache-2.0
// Compares Kaplan-Meier estimates with values by hand. Shares are products of 1 - d/n. Variances are sums of d/(n (n -
// d)).
#include "base/statistics/survival.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace robochart::statistics {
namespace {

TEST(Survival, WithoutCensoringItIsTheShareLeft) {
    const auto steps = survival_curve({{3, true}, {1, true}, {2, true}, {2, true}}, 0.05);
    ASSERT_EQ(steps.size(), 3U);
    EXPECT_DOUBLE_EQ(steps[0].share, 0.75);
    EXPECT_DOUBLE_EQ(steps[1].share, 0.25);
    EXPECT_DOUBLE_EQ(steps[2].share, 0);
    EXPECT_EQ(median_time(steps), 2);
}

/// Six trials: one has its event at 1, one is censored at 2, two have their event at 3, one is censored at 3, and one
/// remains.
TEST(Survival, WhoIsLostLeavesThoseThatAreAskedLater) {
    const auto steps = survival_curve({{1, true}, {2, false}, {3, true}, {3, true}, {3, false}, {9, false}}, 0.05);
    ASSERT_EQ(steps.size(), 2U);
    EXPECT_DOUBLE_EQ(steps[0].share, 5 / 6.0);
    EXPECT_DOUBLE_EQ(steps[1].share, 5 / 6.0 * (1 - 2 / 4.0));
    // The interval is log(-log S) plus and minus 1.96 of its standard deviations, which are sqrt(1/(6 5) + 2/(4 2)) /
    // |log S|.
    const double share = steps[1].share;
    const double deviation = std::sqrt(1 / 30.0 + 2 / 8.0) / std::abs(std::log(share));
    const double middle = std::log(-std::log(share));
    EXPECT_NEAR(steps[1].band.low, std::exp(-std::exp(middle + 1.959964 * deviation)), 1e-6);
    EXPECT_NEAR(steps[1].band.high, std::exp(-std::exp(middle - 1.959964 * deviation)), 1e-6);
    EXPECT_LT(steps[1].band.low, share);
    EXPECT_GT(steps[1].band.high, share);
}

TEST(Survival, WhatNeverComesHasNoMedian) {
    EXPECT_EQ(median_time(survival_curve({{5, false}, {5, false}}, 0.05)), std::nullopt);
    EXPECT_EQ(median_time(survival_curve({{5, false}, {1, true}, {5, false}}, 0.05)), std::nullopt);
    EXPECT_TRUE(survival_curve({}, 0.05).empty());
}

}  // namespace
}  // namespace robochart::statistics
