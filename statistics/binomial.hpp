// Tails of the binomial distribution and the interval of Clopper and Pearson, "The use of confidence or fiducial limits
// illustrated in the case of the binomial", Biometrika 26, 1934. Rounding can only widen an interval.
#pragma once

#include <cstdint>

namespace robochart::statistics {

/// The relative error of a tail of so many trials is at most this: 1e-8 up to 10^8 of them, then in proportion.
[[nodiscard]] double rounding(std::uint64_t trials);

/// Between two probabilities, both included.
struct Interval {
    double low = 0;
    double high = 1;

    friend bool operator==(const Interval&, const Interval&) = default;
};

/// The natural logarithm of n!.
[[nodiscard]] long double log_factorial(std::uint64_t n);
/// P(X >= successes) and P(X <= successes) of a binomial X of so many trials with this probability each.
[[nodiscard]] double at_least(std::uint64_t successes, std::uint64_t trials, double probability);
[[nodiscard]] double at_most(std::uint64_t successes, std::uint64_t trials, double probability);

/// The greatest probability p with P(X >= successes) <= error at every probability up to p: below it lies the true one
/// with a chance of at most `error`. 0 without a success.
[[nodiscard]] double lower_bound(std::uint64_t successes, std::uint64_t trials, double error);
/// The least with P(X <= successes) <= error at every probability from it on. 1 where all succeed.
[[nodiscard]] double upper_bound(std::uint64_t successes, std::uint64_t trials, double error);

/// Both bounds, half of the error each: contains the true probability with a chance of at least 1 - error, for a number
/// of trials that was fixed before. Without trials all of [0, 1].
[[nodiscard]] Interval clopper_pearson(std::uint64_t successes, std::uint64_t trials, double error);

}  // namespace robochart::statistics
