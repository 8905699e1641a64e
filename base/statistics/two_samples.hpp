// SPDX-License-Identifier: Apache-2.0
// Tests whether two samples of trials can have the same probability. Also adjusts the p-values of several such tests.
#pragma once

#include <cstdint>
#include <vector>

namespace robochart::statistics {

/// The number of trials, and the number of successes among them.
struct Sample {
    std::uint64_t successes = 0;
    std::uint64_t trials = 0;
};

/// Computes Fisher's exact test of equal probabilities, two-sided (Statistical Methods for Research Workers, 5th ed.,
/// 1934, 21.02). The test considers all divisions of the total number of successes between the samples. It returns the
/// p-value: the chance of a division that is at most as likely as the observed one. If both samples have the same
/// probability, the result is at most p with a chance of at most p. The numbers of trials must be fixed in advance.
[[nodiscard]] double fisher_exact(Sample, Sample);

/// Adjusts the p-values of several tests, so that all tests whose adjusted p-value is at most `error` may be rejected
/// together. The chance that any rejection is wrong is then at most `error` (Holm, "A simple sequentially rejective
/// multiple test procedure", Scandinavian Journal of Statistics 6, 1979).
[[nodiscard]] std::vector<double> holm_correction(const std::vector<double>& chances);

}  // namespace robochart::statistics
