// Confidence intervals of means, from independent samples.
#pragma once

#include <cstdint>

namespace robochart::statistics {

/// The value that a variable exceeds with this probability: of the normal distribution, and of Student's t.
[[nodiscard]] double normal_quantile(double tail);
[[nodiscard]] double student_quantile(double tail, std::uint64_t freedom);
/// The probability to exceed a value.
[[nodiscard]] double normal_tail(double value);
[[nodiscard]] double student_tail(double value, std::uint64_t freedom);

/// As many samples that the mean of as many hits misses their probability by more than `epsilon` with probability at
/// most `delta`: the bound of Hoeffding, as Herault, Lassaigne, Magniette and Peyronnet use it (Approximate
/// probabilistic model checking, VMCAI 2004). The least number n with 2 exp(-2 n epsilon^2) <= delta, and this formula
/// solved for the others.
[[nodiscard]] double hoeffding_samples(double epsilon, double delta);
[[nodiscard]] double hoeffding_epsilon(double samples, double delta);
[[nodiscard]] double hoeffding_delta(double samples, double epsilon);

/// Numbers added one at a time.
class Moments {
public:
    void add(double value);
    [[nodiscard]] std::uint64_t count() const { return count_; }
    [[nodiscard]] double mean() const { return mean_; }
    /// The unbiased estimate of the variance; 0 for a single number.
    [[nodiscard]] double variance() const;
    /// The deviation of the mean from the expectation, as it is estimated.
    [[nodiscard]] double standard_error() const;

private:
    std::uint64_t count_ = 0;
    double mean_ = 0;
    double squares_ = 0;  ///< of differences from the mean (Welford, Technometrics 4, 1962)
};

}  // namespace robochart::statistics
