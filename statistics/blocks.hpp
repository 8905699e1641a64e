// Whether treatments differ that were each tried once on the same blocks: tests by ranks, which ask nothing of how
// costs are distributed, and the t-test of pairs. Lower is better.
#pragma once

#include <cstdint>
#include <vector>

namespace robochart::statistics {

/// The costs of one block, treatment by treatment. All blocks of a table have the same length.
using Block = std::vector<double>;

/// The places of the costs of a block, from 1 for the lowest; those that are equal share the mean of theirs.
[[nodiscard]] std::vector<double> ranks(const Block&);

/// Friedman's test of at least two treatments, and what follows from it.
struct Friedman {
    std::vector<double> sums;  ///< of each treatment's ranks over all blocks
    double chance = 1;         ///< of ranks that differ so much or more where no treatment is better than another
    double spread = 0;         ///< see `difference`
    std::uint64_t freedom = 0;

    /// Two treatments differ at this error where their sums do by more than this.
    [[nodiscard]] double difference(double error) const;
};
/// The statistic with its correction for ties, against the chi-squared distribution, and differences of rank sums after
/// it, against Student's t (Conover, Practical Nonparametric Statistics, 3rd ed., 1999, 5.8). At least one block.
[[nodiscard]] Friedman friedman(const std::vector<Block>&);

/// The signed-rank test of two treatments (Wilcoxon, "Individual comparisons by ranking methods", Biometrics Bulletin
/// 1, 1945), two-sided and exact: the share of all ways to give signs to the ranks of the differences, those of 0 left
/// out, whose sum is as far from its mean, or farther. At most 5,000 differences that are not 0.
[[nodiscard]] double signed_rank(const std::vector<double>& differences);

/// The t-test of pairs, two-sided. 1 for less than two differences, and where none differs from 0.
[[nodiscard]] double paired_t(const std::vector<double>& differences);

}  // namespace robochart::statistics
