// SPDX-License-Identifier: Apache-2.0
// Declares the estimate of a value from samples.
#pragma once

#include <cstdint>
#include <optional>

#include "base/statistics/binomial.hpp"
#include "prism/sampling/method.hpp"

namespace robochart::prism {

struct Estimate {
    Method::Kind method = Method::Kind::ci;
    std::uint64_t samples = 0;
    double mean = 0;
    double alpha = 0;             ///< the maximal probability that an interval does not contain the value (ci and aci:
                                  ///< approximately)
    std::optional<double> width;  ///< half of the method's interval around the mean; no value for sprt
    std::optional<std::uint64_t> hits;             ///< for a probability: number of paths on which the formula holds
    std::optional<statistics::Interval> binomial;  ///< for a probability: the Clopper-Pearson interval
    double mean_steps = 0;                         ///< mean length of the paths
    std::uint64_t least_steps = 0, most_steps = 0;
};

}  // namespace robochart::prism
