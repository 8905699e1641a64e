// SPDX-License-Identifier: Apache-2.0
// Computes tails and bounds. A tail is a sum of terms, which are added from the greatest outwards. Bounds are found by
// bisection: the result is the end of the last interval at which the tail, including its rounding error, is small
// enough.
#include "base/statistics/binomial.hpp"

#include <algorithm>
#include <cmath>

namespace robochart::statistics {

/// Returns the logarithm of n!. It does not use lgamma, which writes a variable that all threads share.
long double log_factorial(std::uint64_t n) {
    int sign = 0;
    return lgammal_r(static_cast<long double>(n) + 1, &sign);
}

namespace {

/// Returns P(X = k), for a probability strictly between 0 and 1.
long double binomial_term(std::uint64_t k, std::uint64_t n, long double p) {
    return std::exp(log_factorial(n) - log_factorial(k) - log_factorial(n - k) +
                    static_cast<long double>(k) * std::log(p) + static_cast<long double>(n - k) * std::log1p(-p));
}

/// Returns the sum of P(X = i) for i from `low` to `high`. The terms increase up to the mode and decrease after it. So
/// the terms omitted at an end are smaller than the last term added at this end.
long double sum_of_terms(std::uint64_t low, std::uint64_t high, std::uint64_t n, double probability) {
    constexpr long double negligible = 1e-13L;
    const long double p = probability;
    const long double odds = p / (1 - p);
    const auto mode = static_cast<std::uint64_t>((static_cast<long double>(n) + 1) * p);
    const std::uint64_t start = std::clamp(mode, low, high);
    const long double first = binomial_term(start, n, p);
    const auto over = static_cast<long double>(n);
    long double total = first;
    long double next = first;
    for (std::uint64_t i = start; i < high && next * over > negligible * total; ++i) {
        next *= static_cast<long double>(n - i) / static_cast<long double>(i + 1) * odds;
        total += next;
    }
    next = first;
    for (std::uint64_t i = start; i > low && next * over > negligible * total; --i) {
        next *= static_cast<long double>(i) / static_cast<long double>(n - i + 1) / odds;
        total += next;
    }
    return total < 1 ? total : 1;
}

}  // namespace

double rounding_error(std::uint64_t trials) {
    // A term is the exponential of a sum of logarithms. The logarithms are about n ln n, and each has a relative error
    // of 2^-63.
    return 1e-8 * std::max(1.0, static_cast<double>(trials) / 1e8);
}

double at_least(std::uint64_t successes, std::uint64_t trials, double probability) {
    if (successes == 0) return 1;
    if (successes > trials || probability <= 0) return 0;
    return probability >= 1 ? 1 : static_cast<double>(sum_of_terms(successes, trials, trials, probability));
}

double at_most(std::uint64_t successes, std::uint64_t trials, double probability) {
    if (successes >= trials) return 1;
    if (probability >= 1) return 0;
    return probability <= 0 ? 1 : static_cast<double>(sum_of_terms(0, successes, trials, probability));
}

double lower_bound(std::uint64_t successes, std::uint64_t trials, double error) {
    if (successes == 0) return 0;
    // The tail increases with the probability: it is small enough at `low` and too large at `high`.
    double low = 0;
    double high = static_cast<double>(successes) / static_cast<double>(trials);
    for (double middle = high / 2; low < middle && middle < high; middle = low + (high - low) / 2)
        (at_least(successes, trials, middle) * (1 + rounding_error(trials)) <= error ? low : high) = middle;
    return low;
}

double upper_bound(std::uint64_t successes, std::uint64_t trials, double error) {
    if (successes >= trials) return 1;
    double high = 1;
    double low = static_cast<double>(successes) / static_cast<double>(trials);
    for (double middle = low + (high - low) / 2; low < middle && middle < high; middle = low + (high - low) / 2)
        (at_most(successes, trials, middle) * (1 + rounding_error(trials)) <= error ? high : low) = middle;
    return high;
}

Interval clopper_pearson(std::uint64_t successes, std::uint64_t trials, double error) {
    return {lower_bound(successes, trials, error / 2), upper_bound(successes, trials, error / 2)};
}

}  // namespace robochart::statistics
