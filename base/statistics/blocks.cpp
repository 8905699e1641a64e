// SPDX-License-Identifier: Apache-2.0
// Implements the rank tests and the paired t-test.
#include "base/statistics/blocks.hpp"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/statistics/means.hpp"

namespace robochart::statistics {

std::vector<double> mean_ranks(const Block& costs) {
    std::vector<std::size_t> order(costs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return costs[a] < costs[b]; });
    std::vector<double> result(costs.size());
    for (std::size_t i = 0; i < order.size();) {
        std::size_t end = i;
        while (end < order.size() && costs[order[end]] == costs[order[i]]) ++end;
        const double shared = static_cast<double>(i + 1 + end) / 2;
        for (; i < end; ++i) result[order[i]] = shared;
    }
    return result;
}

Friedman friedman_test(const std::vector<Block>& blocks) {
    const auto n = static_cast<double>(blocks.size());
    const auto k = static_cast<double>(blocks.front().size());
    Friedman found;
    found.sums.resize(blocks.front().size());
    double squares = 0;
    for (const Block& block : blocks) {
        const std::vector<double> places = mean_ranks(block);
        for (std::size_t t = 0; t < places.size(); ++t) {
            found.sums[t] += places[t];
            squares += places[t] * places[t];
        }
    }
    double between = 0;
    double of_sums = 0;
    for (const double sum : found.sums) {
        between += (sum - n * (k + 1) / 2) * (sum - n * (k + 1) / 2);
        of_sums += sum * sum;
    }
    const double within = squares - n * k * (k + 1) * (k + 1) / 4;
    found.freedom = static_cast<std::uint64_t>((n - 1) * (k - 1));
    found.spread = std::max(0.0, 2 * (n * squares - of_sums));
    if (within > 0 && k > 1) found.chance = boost::math::gamma_q((k - 1) / 2, (k - 1) * between / within / 2);
    return found;
}

double Friedman::critical_difference(double error) const {
    if (freedom == 0) return std::numeric_limits<double>::infinity();
    return student_quantile(error / 2, freedom) * std::sqrt(spread / static_cast<double>(freedom));
}

double signed_rank(const std::vector<double>& differences) {
    Block sizes;
    std::vector<bool> positive;
    for (const double difference : differences) {
        if (difference == 0) continue;
        sizes.push_back(std::abs(difference));
        positive.push_back(difference > 0);
    }
    if (sizes.empty()) return 1;
    // Shared ranks are multiples of one half, so the doubled ranks are whole numbers.
    std::vector<std::size_t> doubled;
    for (const double place : mean_ranks(sizes)) doubled.push_back(static_cast<std::size_t>(std::llround(2 * place)));
    const std::size_t all = std::accumulate(doubled.begin(), doubled.end(), std::size_t{0});
    std::size_t seen = 0;
    for (std::size_t i = 0; i < doubled.size(); ++i) seen += positive[i] ? doubled[i] : 0;
    std::vector<double> chances(all + 1);  // by sum: its probability
    chances[0] = 1;
    std::size_t most = 0;
    for (const std::size_t rank : doubled) {
        most += rank;
        for (std::size_t sum = most + 1; sum-- > 0;)
            chances[sum] = (chances[sum] + (sum >= rank ? chances[sum - rank] : 0)) / 2;
    }
    const auto distance = [&](std::size_t sum) { return sum * 2 > all ? sum * 2 - all : all - sum * 2; };
    double chance = 0;
    for (std::size_t sum = 0; sum <= all; ++sum)
        if (distance(sum) >= distance(seen)) chance += chances[sum];
    return std::min(1.0, chance);
}

double paired_t(const std::vector<double>& differences) {
    Moments moments;
    for (const double difference : differences) moments.add(difference);
    if (moments.count() < 2 || moments.mean() == 0) return 1;
    if (moments.standard_error() == 0) return 0;
    return 2 * student_tail(std::abs(moments.mean()) / moments.standard_error(), moments.count() - 1);
}

}  // namespace robochart::statistics
