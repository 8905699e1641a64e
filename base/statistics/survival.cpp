// SPDX-License-Identifier: Apache-2.0
// Computes survival curves and their bands.
#include "base/statistics/survival.hpp"

#include <algorithm>
#include <cmath>

#include "base/statistics/means.hpp"

namespace robochart::statistics {

std::vector<SurvivalStep> survival_curve(std::vector<Duration> durations, double error) {
    std::ranges::sort(durations, [](const Duration& a, const Duration& b) { return a.time < b.time; });
    const double deviations = normal_quantile(error / 2);
    std::vector<SurvivalStep> steps;
    double share = 1;
    double greenwood = 0;  // the sum of d / (n (n - d))
    for (std::size_t i = 0; i < durations.size();) {
        // A trial that ends at exactly this time is still counted as under observation at this time.
        const auto there = static_cast<double>(durations.size() - i);
        const double time = durations[i].time;
        double came = 0;
        for (; i < durations.size() && durations[i].time == time; ++i) came += durations[i].came ? 1 : 0;
        if (came == 0) continue;
        share *= 1 - came / there;
        SurvivalStep step{time, share, {0, 1}};
        if (share > 0) {
            greenwood += came / (there * (there - came));
            const double scale = std::exp(deviations * std::sqrt(greenwood) / std::log(share));
            step.band = {std::pow(share, 1 / scale), std::pow(share, scale)};
        } else {
            step.band = {0, steps.empty() ? 1 : steps.back().band.high};
        }
        steps.push_back(step);
    }
    return steps;
}

std::optional<double> median_time(const std::vector<SurvivalStep>& steps) {
    const auto half = std::ranges::find_if(steps, [](const SurvivalStep& step) { return step.share <= 0.5; });
    return half == steps.end() ? std::nullopt : std::optional(half->time);
}

}  // namespace robochart::statistics
