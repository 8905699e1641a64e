// SPDX-License-Identifier: Apache-2.0
// Compares quantiles with tables, and checks Hoeffding's bound by sums over every outcome.
#include "base/statistics/means.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/statistics/binomial.hpp"

namespace robochart::statistics {
namespace {

/// Hoeffding's bound: the mean of n samples is off by more than epsilon with probability at most delta.
TEST(Means, TheBoundOfHoeffdingHolds) {
    EXPECT_EQ(hoeffding_samples(0.05, 0.01), 1060);  // ln(200) / 0.005 = 1059.66...
    EXPECT_LE(hoeffding_epsilon(1060, 0.01), 0.05);
    EXPECT_LE(hoeffding_delta(1060, 0.05), 0.01);
    for (int i = 1; i < 20; ++i) {
        const double p = i / 20.0;
        double missed = 0;
        for (std::uint64_t k = 0; k <= 1060; ++k)
            if (std::abs(static_cast<double>(k) / 1060 - p) > 0.05)
                missed += at_least(k, 1060, p) - at_least(k + 1, 1060, p);
        EXPECT_LE(missed, 0.01) << p;
    }
}

/// Values from the tables of the distributions (Abramowitz and Stegun, Handbook of Mathematical Functions, 1964, 26.1
/// and 26.10).
TEST(Means, Quantiles) {
    EXPECT_NEAR(normal_quantile(0.025), 1.959963985, 1e-8);
    EXPECT_NEAR(normal_quantile(0.005), 2.575829304, 1e-8);
    EXPECT_NEAR(normal_quantile(0.5), 0, 1e-8);
    EXPECT_NEAR(student_quantile(0.025, 1), 12.706, 1e-3);
    EXPECT_NEAR(student_quantile(0.025, 10), 2.228, 1e-3);
    EXPECT_NEAR(student_quantile(0.005, 30), 2.750, 1e-3);
    EXPECT_NEAR(normal_tail(1.959964), 0.025, 1e-7);
    EXPECT_NEAR(student_tail(2.228, 10), 0.025, 1e-4);
}

TEST(Means, MomentsAreThoseOfTheDefinition) {
    Moments moments;
    for (const double value : {2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0}) moments.add(value);
    EXPECT_DOUBLE_EQ(moments.mean(), 5);
    EXPECT_DOUBLE_EQ(moments.variance(), 32.0 / 7);
    EXPECT_DOUBLE_EQ(moments.standard_error(), std::sqrt(32.0 / 7 / 8));
}

}  // namespace
}  // namespace robochart::statistics
