// SPDX-License-Identifier: Apache-2.0
// Tests whether treatments differ if each was tried once on the same blocks: rank tests, which need no assumption about
// the distribution of costs, and the paired t-test. Lower costs are better.
#pragma once

#include <cstdint>
#include <vector>

namespace robochart::statistics {

/// The costs of one block, by treatment. All blocks of a table have the same length.
using Block = std::vector<double>;

/// The ranks of the costs of a block, from 1 for the lowest. Equal costs share the mean of their ranks.
[[nodiscard]] std::vector<double> mean_ranks(const Block&);

/// Friedman's test of at least two treatments, and comparisons after it.
struct Friedman {
    std::vector<double> sums;  ///< the sum of each treatment's ranks over all blocks
    double chance = 1;  ///< the p-value: the chance of such or larger differences of ranks if no treatment is better
    double spread = 0;  ///< see `critical_difference`
    std::uint64_t freedom = 0;

    /// Two treatments differ at this error if their rank sums differ by more than this value.
    [[nodiscard]] double critical_difference(double error) const;
};
/// The statistic with its correction for ties, compared with the chi-squared distribution. Differences of rank sums are
/// then compared with Student's t (Conover, Practical Nonparametric Statistics, 3rd ed., 1999, 5.8). Needs at least one
/// block.
[[nodiscard]] Friedman friedman_test(const std::vector<Block>&);

/// The signed-rank test of two treatments (Wilcoxon, "Individual comparisons by ranking methods", Biometrics Bulletin
/// 1, 1945), two-sided and exact. The result is the fraction of all assignments of signs to the ranks of the nonzero
/// differences whose sum is at least as far from its mean as the observed one. At most 5,000 differences may be
/// nonzero.
[[nodiscard]] double signed_rank(const std::vector<double>& differences);

/// The paired t-test, two-sided. 1 for fewer than two differences, or if all differences are 0.
[[nodiscard]] double paired_t(const std::vector<double>& differences);

}  // namespace robochart::statistics
