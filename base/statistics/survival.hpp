// SPDX-License-Identifier: Apache-2.0
// Estimates the time until an event if some trials end before the event. The method is that of Kaplan and Meier,
// "Nonparametric estimation from incomplete observations", JASA 53, 1958, with bands by Greenwood's variance on the
// scale log(-log S) (Kalbfleisch and Prentice, The Statistical Analysis of Failure Time Data, 1980). The bands are
// approximate and pointwise: each band is valid for its own time only.
#pragma once

#include <optional>
#include <vector>

#include "base/statistics/binomial.hpp"

namespace robochart::statistics {

/// A trial: the time of the event, or the time at which the trial ended without the event.
struct Duration {
    double time = 0;
    bool came = false;
};

/// A step of the survival curve. It gives the estimated fraction of trials in which the event has not occurred at this
/// time; the fraction is valid until the next step.
struct SurvivalStep {
    double time = 0;
    double share = 1;
    Interval band;
};

/// Returns one step for each time at which an event occurred, ascending. `error`: the error of each band.
[[nodiscard]] std::vector<SurvivalStep> survival_curve(std::vector<Duration>, double error);
/// Returns the time by which the event has occurred in half of the trials. Returns no value if this was not observed.
[[nodiscard]] std::optional<double> median_time(const std::vector<SurvivalStep>&);

}  // namespace robochart::statistics
