// SPDX-License-Identifier: Apache-2.0
// Computes confidence intervals of means from independent samples.
#pragma once

#include <cstdint>

namespace robochart::statistics {

/// Returns the value that a variable exceeds with this probability, for the normal distribution and for Student's t.
[[nodiscard]] double normal_quantile(double tail);
[[nodiscard]] double student_quantile(double tail, std::uint64_t freedom);
/// Returns the probability that a normal variable exceeds a value.
[[nodiscard]] double normal_tail(double value);
[[nodiscard]] double student_tail(double value, std::uint64_t freedom);

/// Returns the number of samples after which the observed frequency differs from the probability by more than `epsilon`
/// with a chance of at most `delta`. This is Hoeffding's bound as used by Herault, Lassaigne, Magniette and Peyronnet
/// (Approximate probabilistic model checking, VMCAI 2004): the least number n with 2 exp(-2 n epsilon^2) <= delta. The
/// functions below solve the formula for the other values.
[[nodiscard]] double hoeffding_samples(double epsilon, double delta);
[[nodiscard]] double hoeffding_epsilon(double samples, double delta);
[[nodiscard]] double hoeffding_delta(double samples, double epsilon);

/// Computes the mean and the variance of numbers that are added one at a time.
class Moments {
public:
    void add(double value);
    [[nodiscard]] std::uint64_t count() const { return count_; }
    [[nodiscard]] double mean() const { return mean_; }
    /// Returns the unbiased estimate of the variance, or 0 for a single number.
    [[nodiscard]] double variance() const;
    /// Returns the estimated standard deviation of the mean.
    [[nodiscard]] double standard_error() const;

private:
    std::uint64_t count_ = 0;
    double mean_ = 0;
    double squares_ = 0;  ///< sum of the squared differences from the mean (Welford, Technometrics 4, 1962)
};

}  // namespace robochart::statistics
