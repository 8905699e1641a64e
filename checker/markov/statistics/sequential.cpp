// See sequential.hpp.
#include "checker/markov/statistics/sequential.hpp"

#include <cmath>

namespace robochart::markov {

SequentialTest::SequentialTest(double threshold, double indifference, double alpha)
    : per_hit_(std::log((threshold - indifference) / (threshold + indifference))),
      per_miss_(std::log((1 - threshold + indifference) / (1 - threshold - indifference))),
      bound_(std::log((1 - alpha) / alpha)) {}

void SequentialTest::add(std::uint64_t hits, std::uint64_t misses) {
    hits_ += hits;
    misses_ += misses;
}

std::optional<bool> SequentialTest::above() const {
    const double ratio = static_cast<double>(hits_) * per_hit_ + static_cast<double>(misses_) * per_miss_;
    if (ratio <= -bound_) return true;
    if (ratio >= bound_) return false;
    return std::nullopt;
}

}  // namespace robochart::markov
