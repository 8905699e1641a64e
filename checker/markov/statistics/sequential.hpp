// The sequential probability ratio test (Wald, Sequential tests of statistical hypotheses, Annals of Mathematical
// Statistics 16, 1945), for a probability against a threshold (Younes and Simmons, CAV 2002).
#pragma once

#include <cstdint>
#include <optional>

namespace robochart::markov {

/// Decides between "at least threshold + indifference" and "at most threshold - indifference". Each answer is wrong
/// with probability at most `alpha` where one of the two is so (Wald's approximation: but for the step past the bound).
class SequentialTest {
public:
    /// Both threshold + indifference and threshold - indifference lie strictly between 0 and 1.
    SequentialTest(double threshold, double indifference, double alpha);

    /// More samples.
    void add(std::uint64_t hits, std::uint64_t misses);
    /// Whether the probability is above the threshold; nothing before that is known.
    [[nodiscard]] std::optional<bool> above() const;

private:
    double per_hit_, per_miss_;  ///< what a sample adds to the logarithm of the likelihood ratio of low to high
    double bound_;               ///< log((1 - alpha) / alpha)
    std::uint64_t hits_ = 0, misses_ = 0;
};

}  // namespace robochart::markov
