// SPDX-License-Identifier: Apache-2.0
// Computes quantiles with Boost.Math, with a relative error of about 1e-15.
#include "base/statistics/means.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace robochart::statistics {
namespace {

boost::math::students_t_distribution<double> student_distribution(std::uint64_t freedom) {
    return boost::math::students_t_distribution<double>(static_cast<double>(freedom));
}

}  // namespace

double normal_quantile(double tail) {
    return boost::math::quantile(boost::math::complement(boost::math::normal(), tail));
}

double student_quantile(double tail, std::uint64_t freedom) {
    return boost::math::quantile(boost::math::complement(student_distribution(freedom), tail));
}

double normal_tail(double value) {
    return boost::math::cdf(boost::math::complement(boost::math::normal(), value));
}

double student_tail(double value, std::uint64_t freedom) {
    return boost::math::cdf(boost::math::complement(student_distribution(freedom), value));
}

double hoeffding_samples(double epsilon, double delta) {
    return std::ceil(std::log(2 / delta) / (2 * epsilon * epsilon));
}

double hoeffding_epsilon(double samples, double delta) {
    return std::sqrt(std::log(2 / delta) / (2 * samples));
}

double hoeffding_delta(double samples, double epsilon) {
    return std::min(1.0, 2 * std::exp(-2 * samples * epsilon * epsilon));
}

void Moments::add(double value) {
    ++count_;
    const double difference = value - mean_;
    mean_ += difference / static_cast<double>(count_);
    squares_ += difference * (value - mean_);
}

double Moments::variance() const {
    return count_ < 2 ? 0 : squares_ / static_cast<double>(count_ - 1);
}

double Moments::standard_error() const {
    return count_ == 0 ? 0 : std::sqrt(variance() / static_cast<double>(count_));
}

}  // namespace robochart::statistics
