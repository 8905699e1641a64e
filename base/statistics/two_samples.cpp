// SPDX-License-Identifier: Apache-2.0
// Implements Fisher's exact test and Holm's correction.
#include "base/statistics/two_samples.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/statistics/binomial.hpp"

namespace robochart::statistics {

double fisher_exact(Sample one, Sample other) {
    const std::uint64_t successes = one.successes + other.successes;
    const std::uint64_t low = successes > other.trials ? successes - other.trials : 0;
    const std::uint64_t high = std::min(successes, one.trials);
    const auto choose = [](std::uint64_t n, std::uint64_t k) {
        return log_factorial(n) - log_factorial(k) - log_factorial(n - k);
    };
    const auto chance = [&](std::uint64_t k) {
        return std::exp(choose(one.trials, k) + choose(other.trials, successes - k) -
                        choose(one.trials + other.trials, successes));
    };
    // Divisions that are as likely as the observed division must be included even with rounding errors.
    const long double most = chance(one.successes) * (1 + 1e-9L);
    long double total = 0;
    for (std::uint64_t k = low; k <= high; ++k)
        if (const long double probability = chance(k); probability <= most) total += probability;
    return static_cast<double>(std::min(total, 1.0L));
}

std::vector<double> holm_correction(const std::vector<double>& chances) {
    std::vector<std::size_t> order(chances.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return chances[a] < chances[b]; });
    std::vector<double> adjusted(chances.size());
    double least = 0;
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
        const auto left = static_cast<double>(order.size() - rank);
        least = std::max(least, std::min(1.0, left * chances[order[rank]]));
        adjusted[order[rank]] = least;
    }
    return adjusted;
}

}  // namespace robochart::statistics
