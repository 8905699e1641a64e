// SPDX-License-Identifier: Apache-2.0
// Implements Wald's test and the looks of confidence intervals.
#include "base/statistics/sequential.hpp"

#include <cmath>

namespace robochart::statistics {

namespace {

constexpr std::uint64_t first_look = 16;

}  // namespace

Sprt::Answer Sprt::answer(std::uint64_t successes, std::uint64_t trials) const {
    const double ratio = static_cast<double>(successes) * std::log(p1 / p0) +
                         static_cast<double>(trials - successes) * std::log((1 - p1) / (1 - p0));
    if (ratio >= -std::log(alpha)) return Answer::below;
    return ratio <= std::log(beta) ? Answer::at_least : Answer::open;
}

Looks::Look Looks::look_from(std::uint64_t trials) const {
    Look look{1, first_look};
    while (look.trials < trials && look.trials < most_) look = {look.number + 1, look.trials + (look.trials + 1) / 2};
    return {look.number, look.trials < most_ ? look.trials : most_};
}

std::optional<std::uint64_t> Looks::trials_of_next_look(std::uint64_t trials) const {
    if (trials >= most_) return std::nullopt;
    return look_from(trials + 1).trials;
}

double Looks::error_share(std::uint64_t trials) const {
    const Look look = look_from(trials);
    if (look.trials != trials) return 0;
    const auto number = static_cast<double>(look.number);
    return look.trials == most_ ? 1 / number : 1 / (number * (number + 1));
}

std::optional<Interval> Looks::interval_after(std::uint64_t successes, std::uint64_t trials) const {
    const double part = error_share(trials);
    if (part == 0) return std::nullopt;
    return clopper_pearson(successes, trials, error_ * part);
}

}  // namespace robochart::statistics
