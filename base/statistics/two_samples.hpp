// SPDX-License-Identifier: Apache-2.0
// Tests whether two samples of trials can have the same probability, and adjusts the p-values of several such tests.
#pragma once

#include <cstdint>
#include <vector>

namespace robochart::statistics {

/// The number of trials and of successes among them.
struct Sample {
    std::uint64_t successes = 0;
    std::uint64_t trials = 0;
};

/// Fisher's exact test of equal probabilities, two-sided (Statistical Methods for Research Workers, 5th ed., 1934,
/// 21.02). Returns the p-value: the chance, given the total number of successes, of a division between the samples that
/// is at most as likely as the observed one. If both samples have the same probability, the result is at most p with a
/// chance of at most p. The numbers of trials must be fixed in advance.
[[nodiscard]] double fisher_exact(Sample, Sample);

/// The p-values of several tests, adjusted so that all those of at most `error` may be rejected together. The chance
/// that any rejection is wrong is then at most `error` (Holm, "A simple sequentially rejective multiple test
/// procedure", Scandinavian Journal of Statistics 6, 1979).
[[nodiscard]] std::vector<double> holm_correction(const std::vector<double>& chances);

}  // namespace robochart::statistics
