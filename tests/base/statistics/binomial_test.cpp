// SPDX-License-Identifier: Apache-2.0
// Compares tail probabilities with exact fractions, and bounds with their definition and closed forms. Sums the
// coverage over every outcome.
#include "base/statistics/binomial.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

namespace robochart::statistics {
namespace {

using Fraction = boost::multiprecision::cpp_rational;

/// Returns P(X = k) for the probability part/whole.
Fraction exact(std::uint64_t k, std::uint64_t n, int part, int whole) {
    Fraction value = 1;
    for (std::uint64_t i = 0; i < k; ++i) value *= Fraction(n - i, i + 1) * Fraction(part, whole);
    for (std::uint64_t i = k; i < n; ++i) value *= Fraction(whole - part, whole);
    return value;
}

TEST(Binomial, TailsAreTheExactOnes) {
    for (const std::uint64_t n : {1U, 2U, 7U, 60U})
        for (const int part : {1, 50, 333, 500, 950, 999}) {
            Fraction below = 0;
            for (std::uint64_t k = 0; k <= n; ++k) {
                const double low = (Fraction(1) - below).convert_to<double>();
                below += exact(k, n, part, 1000);
                const double high = below.convert_to<double>();
                EXPECT_NEAR(at_least(k, n, part / 1000.0), low, rounding_error(n) * low) << k << " of " << n;
                EXPECT_NEAR(at_most(k, n, part / 1000.0), high, rounding_error(n) * high) << k << " of " << n;
            }
        }
}

TEST(Binomial, ManyTrials) {
    // By symmetry P(X >= n/2) = 1/2 + P(X = n/2)/2, and P(X = n/2) is 1/sqrt(pi n/2) up to a factor 1 - 1/(4n).
    const double n = 1e8;
    EXPECT_NEAR(at_least(50'000'000, 100'000'000, 0.5), 0.5 + 0.5 / std::sqrt(M_PI * n / 2), 1e-9);
    EXPECT_NEAR(at_most(50'000'000, 100'000'000, 0.5), 0.5 + 0.5 / std::sqrt(M_PI * n / 2), 1e-9);
}

TEST(Binomial, Ends) {
    EXPECT_EQ(at_least(0, 5, 0.0), 1);
    EXPECT_EQ(at_least(1, 5, 0.0), 0);
    EXPECT_EQ(at_least(5, 5, 1.0), 1);
    EXPECT_EQ(at_least(6, 5, 0.5), 0);
    EXPECT_EQ(at_most(4, 5, 1.0), 0);
    EXPECT_EQ(at_most(0, 5, 0.0), 1);
    EXPECT_EQ(clopper_pearson(0, 0, 0.05), (Interval{0, 1}));
}

/// Without a failure, L^n = error. Without a success, (1 - U)^n = error.
TEST(ClopperPearson, AllOrNone) {
    for (const std::uint64_t n : {1U, 59U, 299U, 2995U}) {
        const double root = std::pow(0.025, 1 / static_cast<double>(n));
        EXPECT_NEAR(clopper_pearson(n, n, 0.05).low, root, 1e-8);
        EXPECT_EQ(clopper_pearson(n, n, 0.05).high, 1);
        EXPECT_NEAR(clopper_pearson(0, n, 0.05).high, 1 - root, 1e-8);
        EXPECT_EQ(clopper_pearson(0, n, 0.05).low, 0);
    }
    // The rule of three: 59 trials without failure show p <= 5 % at 95 %, 58 do not.
    EXPECT_LE(upper_bound(0, 59, 0.05), 0.05);
    EXPECT_GT(upper_bound(0, 58, 0.05), 0.05);
}

/// The bounds are tight and never on the wrong side.
TEST(ClopperPearson, TheTailAtABoundIsTheError) {
    for (const std::uint64_t n : {1U, 10U, 77U, 1000U, 100'000U})
        for (const double share : {0.001, 0.1, 0.5, 0.93, 1.0})
            for (const double error : {0.1, 0.005, 1e-6}) {
                const auto x = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(n)));
                EXPECT_LE(at_least(x, n, lower_bound(x, n, error)), error);
                EXPECT_GE(at_least(x, n, lower_bound(x, n, error)), error * (1 - 1e-5)) << x << " of " << n;
                const std::uint64_t y = n - x;
                EXPECT_LE(at_most(y, n, upper_bound(y, n, error)), error);
                EXPECT_GE(at_most(y, n, upper_bound(y, n, error)), error * (1 - 1e-5)) << y << " of " << n;
            }
}

/// The coverage, summed over every outcome, is at least nominal for every true probability.
TEST(ClopperPearson, CoversAtLeastAsOftenAsItSays) {
    for (const double error : {0.05, 0.01})
        for (const std::uint64_t n : {1U, 5U, 20U, 59U, 200U}) {
            std::vector<Interval> intervals;
            for (std::uint64_t k = 0; k <= n; ++k) intervals.push_back(clopper_pearson(k, n, error));
            for (int part = 1; part < 200; ++part) {
                const double p = part / 200.0;
                double covered = 0;
                for (std::uint64_t k = 0; k <= n; ++k)
                    if (intervals[k].low <= p && p <= intervals[k].high)
                        covered += k == n ? at_least(k, n, p) : at_least(k, n, p) - at_least(k + 1, n, p);
                EXPECT_GE(covered, 1 - error) << n << " trials, p = " << p;
            }
        }
}

}  // namespace
}  // namespace robochart::statistics
