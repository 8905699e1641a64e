// SPDX-License-Identifier: Apache-2.0
// Compares tests on blocks with values computed by hand, and with sums over every outcome of small tables.
#include "base/statistics/blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace robochart::statistics {
namespace {

TEST(Blocks, EqualCostsShareTheirRanks) {
    EXPECT_EQ(mean_ranks({3, 1, 2}), (std::vector<double>{3, 1, 2}));
    EXPECT_EQ(mean_ranks({5, 5, 1, 5}), (std::vector<double>{3, 3, 1, 3}));
    EXPECT_EQ(mean_ranks({}), std::vector<double>{});
}

/// Three treatments have the same order in each of 4 blocks, so the rank sums are 4, 8, 12 around a mean of 8. The
/// statistic is 2 (16 + 0 + 16) / (4 * 14 - 48) = 8. With two degrees of freedom its p-value is exp(-8/2).
TEST(Friedman, PerfectAgreement) {
    const Friedman found = friedman_test({{1, 2, 3}, {10, 20, 30}, {0.1, 0.2, 0.3}, {7, 8, 9}});
    EXPECT_EQ(found.sums, (std::vector<double>{4, 8, 12}));
    EXPECT_NEAR(found.chance, std::exp(-4.0), 1e-12);
    EXPECT_EQ(found.critical_difference(0.05), 0) << "no rank varies, so any difference counts";
}

TEST(Friedman, NothingDiffers) {
    EXPECT_EQ(friedman_test({{1, 1, 1}, {2, 2, 2}}).chance, 1);
    const Friedman opposed = friedman_test({{1, 2}, {2, 1}});
    EXPECT_EQ(opposed.chance, 1) << "as often better as worse";
    EXPECT_GT(opposed.critical_difference(0.05), 1);
}

/// Of two treatments in 10 blocks, one is better in all blocks but one, so the rank sums are 11 and 19. By Conover's
/// formula the least significant difference is t(0.975; 9) sqrt(2 (10 * 50 - 11^2 - 19^2) / 9) = 2.2622 sqrt(36 / 9) =
/// 4.5243.
TEST(Friedman, DifferencesAfterIt) {
    std::vector<Block> blocks(9, Block{1, 2});
    blocks.push_back({2, 1});
    const Friedman found = friedman_test(blocks);
    EXPECT_EQ(found.sums, (std::vector<double>{11, 19}));
    EXPECT_NEAR(found.critical_difference(0.05), 2.262157 * 2, 1e-5);
    // The statistic is (4^2 + 4^2) / (50 - 45) = 6.4 with one degree of freedom. Its p-value is the probability of |Z|
    // >= sqrt(6.4).
    EXPECT_NEAR(found.chance, std::erfc(std::sqrt(3.2)), 1e-12);
}

/// If all six differences are positive, 2 of 64 sign patterns are as extreme. If only the smallest of the ranks 1 to 6
/// is negative, 4 of 64 are as extreme: those with the sums 20 and 21, and their mirror images.
TEST(SignedRank, ByCounting) {
    EXPECT_NEAR(signed_rank({1, 2, 3, 4, 5, 6}), 2.0 / 64, 1e-15);
    EXPECT_NEAR(signed_rank({-1, 2, 3, 4, 5, 6}), 4.0 / 64, 1e-15);
    EXPECT_EQ(signed_rank({}), 1);
    EXPECT_EQ(signed_rank({0, 0}), 1) << "what is equal says nothing";
    EXPECT_NEAR(signed_rank({0, 1, 2, 3, 4, 5, 6, 0}), 2.0 / 64, 1e-15);
}

/// Over all sign patterns of differences, the probability of a p-value of at most p is at most p. This also holds for
/// ties.
TEST(SignedRank, ErrsAtMostAsOftenAsItSays) {
    for (const std::vector<double>& sizes :
         {std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, std::vector<double>{1, 1, 1, 2, 2, 5, 5, 5, 5}}) {
        std::vector<double> chances;
        for (unsigned signs = 0; signs < 1U << sizes.size(); ++signs) {
            std::vector<double> differences;
            for (std::size_t i = 0; i < sizes.size(); ++i)
                differences.push_back((signs >> i & 1U) != 0 ? sizes[i] : -sizes[i]);
            chances.push_back(signed_rank(differences));
        }
        for (const double error : {0.01, 0.05, 0.2}) {
            const auto rejected = std::ranges::count_if(chances, [&](double chance) { return chance <= error; });
            EXPECT_LE(static_cast<double>(rejected), error * static_cast<double>(chances.size()));
        }
    }
}

/// The differences 1, 2, 3 have the mean 2 and the standard error 1/sqrt(3), so t = 2 sqrt(3). With two degrees of
/// freedom the probability of a larger value is (1 - t/sqrt(2 + t^2)) / 2 on each side.
TEST(PairedT, ByHand) {
    const double t = 2 * std::sqrt(3.0);
    EXPECT_NEAR(paired_t({1, 2, 3}), 1 - t / std::sqrt(2 + t * t), 1e-12);
    EXPECT_EQ(paired_t({5}), 1);
    EXPECT_EQ(paired_t({0, 0, 0}), 1);
    EXPECT_EQ(paired_t({2, 2, 2}), 0);
}

}  // namespace
}  // namespace robochart::statistics
