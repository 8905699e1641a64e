// SPDX-License-Identifier: Apache-2.0
// Computes tails of the binomial distribution, and the interval of Clopper and Pearson, "The use of confidence or
// fiducial limits illustrated in the case of the binomial", Biometrika 26, 1934. Rounding errors can only widen an
// interval.
#pragma once

#include <cstdint>

namespace robochart::statistics {

/// Returns an upper bound on the relative error of a tail. It is 1e-8 for up to 10^8 trials, and then proportional to
/// the number of trials.
[[nodiscard]] double rounding_error(std::uint64_t trials);

/// An interval of probabilities, which includes both ends.
struct Interval {
    double low = 0;
    double high = 1;

    friend bool operator==(const Interval&, const Interval&) = default;
};

/// Returns the natural logarithm of n!.
[[nodiscard]] long double log_factorial(std::uint64_t n);
/// These functions return P(X >= successes) and P(X <= successes), where X is the number of successes in `trials`
/// trials with this probability.
[[nodiscard]] double at_least(std::uint64_t successes, std::uint64_t trials, double probability);
[[nodiscard]] double at_most(std::uint64_t successes, std::uint64_t trials, double probability);

/// Returns the greatest p such that P(X >= successes) <= error for every probability up to p. The chance that the true
/// probability is less than this bound is at most `error`. The bound is 0 if no trial succeeded.
[[nodiscard]] double lower_bound(std::uint64_t successes, std::uint64_t trials, double error);
/// Returns the least p such that P(X <= successes) <= error for every probability from p on. The bound is 1 if all
/// trials succeeded.
[[nodiscard]] double upper_bound(std::uint64_t successes, std::uint64_t trials, double error);

/// Returns both bounds, each with half of the error. The interval contains the true probability with a chance of at
/// least 1 - error, if the number of trials was fixed in advance. Without trials it is [0, 1].
[[nodiscard]] Interval clopper_pearson(std::uint64_t successes, std::uint64_t trials, double error);

}  // namespace robochart::statistics
