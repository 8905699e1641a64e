// What samples say of a value.
#pragma once

#include <cstdint>
#include <optional>

#include "checker/prism/sampling/method.hpp"
#include "statistics/binomial.hpp"

namespace robochart::prism {

struct Estimate {
    Method::Kind method = Method::Kind::ci;
    std::uint64_t samples = 0;
    double mean = 0;
    double alpha = 0;  ///< each interval misses the value with probability at most this (ci and aci: about this)
    std::optional<double> width;                   ///< half of the method's interval around the mean; sprt has none
    std::optional<std::uint64_t> hits;             ///< of a probability: paths on which the formula holds
    std::optional<statistics::Interval> binomial;  ///< of a probability: the interval of Clopper and Pearson
    double mean_steps = 0;                         ///< how long the paths were
    std::uint64_t least_steps = 0, most_steps = 0;
};

}  // namespace robochart::prism
