// SPDX-License-Identifier: Apache-2.0
// Tests whether treatments differ if each of them was tried once on the same blocks. The tests are rank tests, which
// need no assumption about the distribution of costs, and the paired t-test. Lower costs are better.
#pragma once

#include <cstdint>
#include <vector>

namespace robochart::statistics {

/// The costs of one block, one for each treatment. All blocks of a table have the same length.
using Block = std::vector<double>;

/// Returns the ranks of the costs of a block, from 1 for the lowest cost. Equal costs share the mean of their ranks.
[[nodiscard]] std::vector<double> mean_ranks(const Block&);

/// The result of Friedman's test of at least two treatments, with which they can be compared.
struct Friedman {
    std::vector<double> sums;  ///< for each treatment, the sum of its ranks over all blocks
    double chance = 1;  ///< p-value: the chance of rank differences this large or larger if no treatment is better
    double spread = 0;  ///< see `critical_difference`
    std::uint64_t freedom = 0;

    /// Returns the critical difference: two treatments differ at this error if their rank sums differ by more than this
    /// value.
    [[nodiscard]] double critical_difference(double error) const;
};
/// Computes the statistic with its correction for ties, and compares it with the chi-squared distribution. Afterwards,
/// differences of rank sums can be compared with Student's t (Conover, Practical Nonparametric Statistics, 3rd ed.,
/// 1999, 5.8). There must be at least one block.
[[nodiscard]] Friedman friedman_test(const std::vector<Block>&);

/// Computes the signed-rank test of two treatments (Wilcoxon, "Individual comparisons by ranking methods", Biometrics
/// Bulletin 1, 1945), two-sided and exact. The test considers all assignments of signs to the ranks of the nonzero
/// differences. It returns the fraction of assignments whose sum is at least as far from the mean as the observed sum.
/// At most 5,000 differences may be nonzero.
[[nodiscard]] double signed_rank(const std::vector<double>& differences);

/// Returns the p-value of the paired t-test, two-sided. It is 1 for fewer than two differences, and if all differences
/// are 0.
[[nodiscard]] double paired_t(const std::vector<double>& differences);

}  // namespace robochart::statistics
