// SPDX-License-Identifier: Apache-2.0
// Compares Fisher's test with tables computed by hand, and its error with sums over every outcome. Compares Holm's
// adjustment with values by hand.
#include "base/statistics/two_samples.hpp"

#include <gtest/gtest.h>

#include "base/statistics/binomial.hpp"

namespace robochart::statistics {
namespace {

/// Of 8 cups of tea, 4 had the milk first. By chance, a taster identifies all 4 in one of (8 choose 4) = 70 selections,
/// and none of them in one. The taster identifies 3 of 4 in 16 of 70 selections (Fisher, The Design of Experiments,
/// 1935, chapter II).
TEST(FisherExact, TheLadyTastingTea) {
    EXPECT_NEAR(fisher_exact({4, 4}, {0, 4}), 2.0 / 70, 1e-12);
    EXPECT_NEAR(fisher_exact({3, 4}, {1, 4}), 34.0 / 70, 1e-12);
    EXPECT_NEAR(fisher_exact({2, 4}, {2, 4}), 1, 1e-12);
}

TEST(FisherExact, Ends) {
    EXPECT_NEAR(fisher_exact({0, 100}, {0, 200}), 1, 1e-12);
    EXPECT_NEAR(fisher_exact({100, 100}, {7, 7}), 1, 1e-12);
    EXPECT_NEAR(fisher_exact({0, 0}, {3, 9}), 1, 1e-12) << "no trials say nothing";
    // Ten of ten successes are compared with none of ten. Two of the (20 choose 10) divisions are as extreme.
    EXPECT_NEAR(fisher_exact({10, 10}, {0, 10}), 2.0 / 184'756, 1e-15);
}

/// If both samples have the same probability, the p-value is at most `error` in at most this share of outcomes.
TEST(FisherExact, ErrsAtMostAsOftenAsItSays) {
    constexpr std::uint64_t n = 30;
    constexpr std::uint64_t m = 17;
    const auto chance = [](std::uint64_t k, std::uint64_t trials, double p) {
        return at_least(k, trials, p) - (k < trials ? at_least(k + 1, trials, p) : 0);
    };
    for (const double error : {0.05, 0.01})
        for (const double p : {0.02, 0.2, 0.5, 0.95}) {
            double rejected = 0;
            for (std::uint64_t x = 0; x <= n; ++x)
                for (std::uint64_t y = 0; y <= m; ++y)
                    if (fisher_exact({x, n}, {y, m}) <= error) rejected += chance(x, n, p) * chance(y, m, p);
            EXPECT_LE(rejected, error) << p;
            if (p == 0.5) {
                EXPECT_GE(rejected, error / 5) << "a test that never rejects would pass the above";
            }
        }
}

TEST(Holm, AdjustsByHand) {
    // In ascending order, the values are .01 * 4, .02 * 3, .03 * 2 and .04. No adjusted value may be below the previous
    // one.
    const std::vector<double> adjusted = holm_correction({0.03, 0.01, 0.04, 0.02});
    const std::vector<double> expected{0.06, 0.04, 0.06, 0.06};
    ASSERT_EQ(adjusted.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(adjusted[i], expected[i], 1e-12) << i;
    EXPECT_EQ(holm_correction({0.7, 0.9}), (std::vector<double>{1, 1}));
    EXPECT_TRUE(holm_correction({}).empty());
}

}  // namespace
}  // namespace robochart::statistics
