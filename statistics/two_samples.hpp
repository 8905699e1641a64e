// Whether two samples of trials can have the same probability, and several such tests at once.
#pragma once

#include <cstdint>
#include <vector>

namespace robochart::statistics {

/// So many of the trials succeeded.
struct Sample {
    std::uint64_t successes = 0;
    std::uint64_t trials = 0;
};

/// Fisher's exact test of equal probabilities, two-sided (Statistical Methods for Research Workers, 5th ed., 1934,
/// 21.02): the chance, given how many of all trials succeeded, of a division among the samples that is not more likely
/// than this one. Where both samples have the same probability it is at most p with a chance of at most p. Numbers of
/// trials that were fixed before.
[[nodiscard]] double fisher_exact(Sample, Sample);

/// The chances of several tests, adjusted so that those at most `error` may be rejected together: the chance that any
/// of these is wrong is then at most `error` (Holm, "A simple sequentially rejective multiple test procedure",
/// Scandinavian Journal of Statistics 6, 1979).
[[nodiscard]] std::vector<double> holm(const std::vector<double>& chances);

}  // namespace robochart::statistics
