// How long something takes where some trials end before it came: Kaplan and Meier, "Nonparametric estimation from
// incomplete observations", JASA 53, 1958, with bands by Greenwood's variance on the scale log(-log S) (Kalbfleisch and
// Prentice, The Statistical Analysis of Failure Time Data, 1980). The bands are approximate, and each is about its own
// time.
#pragma once

#include <optional>
#include <vector>

#include "statistics/binomial.hpp"

namespace robochart::statistics {

/// A trial: it came at this time, or had not come by then.
struct Duration {
    double time = 0;
    bool came = false;
};

/// From this time on the share of trials for which it has not come is estimated so.
struct SurvivalStep {
    double time = 0;
    double share = 1;
    Interval band;
};

/// A step for each time at which it came, ascending. `error`: of each band.
[[nodiscard]] std::vector<SurvivalStep> survival(std::vector<Duration>, double error);
/// The time by which it has come in half of the trials; none if that is never seen.
[[nodiscard]] std::optional<double> median(const std::vector<SurvivalStep>&);

}  // namespace robochart::statistics
