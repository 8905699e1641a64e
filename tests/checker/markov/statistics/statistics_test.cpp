// Intervals and tests of samples. Coverage and error rates are computed exactly, by summing over binomial
// distributions and over all ways that a test can go; nothing is drawn.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "checker/markov/statistics/intervals.hpp"
#include "checker/markov/statistics/sequential.hpp"

namespace robochart::markov {
namespace {

/// The probability of k hits among n samples.
double binomial(std::uint64_t n, std::uint64_t k, double p) {
    if (p <= 0 || p >= 1) return (p <= 0 ? k == 0 : k == n) ? 1 : 0;
    const auto a = static_cast<double>(n);
    const auto b = static_cast<double>(k);
    return std::exp(std::lgamma(a + 1) - std::lgamma(b + 1) - std::lgamma(a - b + 1) + b * std::log(p) +
                    (a - b) * std::log1p(-p));
}

/// Clopper and Pearson, 1934: an interval covers every probability with 1 - alpha at least.
TEST(Statistics, TheBinomialIntervalCoversEveryProbability) {
    for (const std::uint64_t n : {1U, 2U, 5U, 20U, 100U})
        for (const double alpha : {0.2, 0.05, 0.01}) {
            std::vector<Enclosure> intervals;
            for (std::uint64_t k = 0; k <= n; ++k) intervals.push_back(clopper_pearson(k, n, alpha));
            for (int i = 0; i <= 200; ++i) {
                const double p = i / 200.0;
                double covered = 0;
                for (std::uint64_t k = 0; k <= n; ++k)
                    if (intervals[k].low <= p && p <= intervals[k].high) covered += binomial(n, k, p);
                EXPECT_GE(covered, 1 - alpha - 1e-9) << n << " samples, alpha " << alpha << ", p " << p;
            }
        }
}

/// Its ends are where a tail of the binomial distribution has alpha/2, so it is not wider than it must be.
TEST(Statistics, TheEndsOfTheBinomialIntervalAreThoseOfTheDefinition) {
    for (const std::uint64_t n : {3U, 10U, 57U})
        for (std::uint64_t k = 0; k <= n; ++k) {
            const Enclosure interval = clopper_pearson(k, n, 0.05);
            double above = 0;
            double below = 0;
            for (std::uint64_t j = 0; j <= n; ++j) {
                if (j >= k) above += binomial(n, j, interval.low);
                if (j <= k) below += binomial(n, j, interval.high);
            }
            EXPECT_NEAR(above, k > 0 ? 0.025 : 1, 1e-8) << k << " of " << n;
            EXPECT_NEAR(below, k < n ? 0.025 : 1, 1e-8) << k << " of " << n;
        }
}

/// 100 hits of 100 say at 99 % that the probability is at least (alpha/2)^(1/100): the upper tail is p^100.
TEST(Statistics, AllHitsAreNotCertainty) {
    EXPECT_NEAR(clopper_pearson(100, 100, 0.01).low, std::pow(0.005, 0.01), 1e-9);
    EXPECT_NEAR(clopper_pearson(100, 100, 0.01).low, 0.948, 1e-3);
}

/// Hoeffding's bound: the mean of n samples misses by more than epsilon with probability at most delta.
TEST(Statistics, TheBoundOfHoeffdingHolds) {
    EXPECT_EQ(hoeffding_samples(0.05, 0.01), 1060);  // ln(200) / 0.005 = 1059.66...
    EXPECT_LE(hoeffding_epsilon(1060, 0.01), 0.05);
    EXPECT_LE(hoeffding_delta(1060, 0.05), 0.01);
    for (int i = 1; i < 20; ++i) {
        const double p = i / 20.0;
        double missed = 0;
        for (std::uint64_t k = 0; k <= 1060; ++k)
            if (std::abs(static_cast<double>(k) / 1060 - p) > 0.05) missed += binomial(1060, k, p);
        EXPECT_LE(missed, 0.01) << p;
    }
}

/// Values of the tables of the distributions (Abramowitz and Stegun, Handbook of Mathematical Functions, 1964, 26.1 and
/// 26.10).
TEST(Statistics, Quantiles) {
    EXPECT_NEAR(normal_quantile(0.025), 1.959964, 1e-6);
    EXPECT_NEAR(normal_quantile(0.005), 2.575829, 1e-6);
    EXPECT_NEAR(student_quantile(0.025, 1), 12.706, 1e-3);
    EXPECT_NEAR(student_quantile(0.025, 10), 2.228, 1e-3);
    EXPECT_NEAR(student_quantile(0.005, 30), 2.750, 1e-3);
    EXPECT_NEAR(normal_tail(1.959964), 0.025, 1e-7);
    EXPECT_NEAR(student_tail(2.228, 10), 0.025, 1e-4);
}

TEST(Statistics, MomentsAreThoseOfTheDefinition) {
    Moments moments;
    for (const double value : {2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0}) moments.add(value);
    EXPECT_DOUBLE_EQ(moments.mean(), 5);
    EXPECT_DOUBLE_EQ(moments.variance(), 32.0 / 7);
    EXPECT_DOUBLE_EQ(moments.standard_error(), std::sqrt(32.0 / 7 / 8));
}

/// The probability that the test says "above" for samples that hit with probability p, summed over all numbers of hits
/// of undecided tests, step by step; what is open after very many steps counts for either.
struct Answers {
    double above = 0, below = 0, open = 0;
};
Answers exact_answers(double threshold, double indifference, double alpha, double p) {
    Answers answers;
    std::map<std::uint64_t, double> open{{0, 1.0}};  // by hits
    for (std::uint64_t samples = 1; samples < 20'000 && !open.empty(); ++samples) {
        std::map<std::uint64_t, double> next;
        for (const auto& [hits, mass] : open) {
            next[hits] += mass * (1 - p);
            next[hits + 1] += mass * p;
        }
        open.clear();
        for (const auto& [hits, mass] : next) {
            SequentialTest test(threshold, indifference, alpha);
            test.add(hits, samples - hits);
            const std::optional<bool> above = test.above();
            if (above)
                (*above ? answers.above : answers.below) += mass;
            else if (mass < 1e-15)
                answers.open += mass;
            else
                open.emplace(hits, mass);
        }
    }
    return answers;
}

/// Wald: with these bounds both errors are together at most 2 alpha, and each at most alpha / (1 - alpha).
TEST(Statistics, TheSequentialTestErrsAsRarelyAsPromised) {
    for (const double threshold : {0.5, 0.25})
        for (const double indifference : {0.1, 0.2})
            for (const double alpha : {0.05, 0.01}) {
                const Answers high = exact_answers(threshold, indifference, alpha, threshold + indifference);
                const Answers low = exact_answers(threshold, indifference, alpha, threshold - indifference);
                const double most = alpha / (1 - alpha);
                EXPECT_LE(high.below + high.open, most) << threshold << " " << indifference << " " << alpha;
                EXPECT_LE(low.above + low.open, most) << threshold << " " << indifference << " " << alpha;
                EXPECT_NEAR(high.above + high.below, 1, 1e-9);
                // Further away it errs less.
                const Answers sure = exact_answers(threshold, indifference, alpha, threshold + 1.5 * indifference);
                EXPECT_LT(sure.below, high.below);
            }
}

}  // namespace
}  // namespace robochart::markov
