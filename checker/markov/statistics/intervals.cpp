// See intervals.hpp. Quantiles are Boost.Math's, good to about 1e-15.
#include "checker/markov/statistics/intervals.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>

namespace robochart::markov {
namespace {

/// More than the error of a quantile.
constexpr double outward = 1e-11;

boost::math::students_t_distribution<double> student(std::uint64_t freedom) {
    return boost::math::students_t_distribution<double>(static_cast<double>(freedom));
}

}  // namespace

double normal_quantile(double tail) {
    return boost::math::quantile(boost::math::complement(boost::math::normal(), tail));
}

double student_quantile(double tail, std::uint64_t freedom) {
    return boost::math::quantile(boost::math::complement(student(freedom), tail));
}

double normal_tail(double value) {
    return boost::math::cdf(boost::math::complement(boost::math::normal(), value));
}

double student_tail(double value, std::uint64_t freedom) {
    return boost::math::cdf(boost::math::complement(student(freedom), value));
}

Enclosure clopper_pearson(std::uint64_t hits, std::uint64_t samples, double alpha) {
    const auto k = static_cast<double>(hits);
    const auto n = static_cast<double>(samples);
    const double low = hits == 0 ? 0 : boost::math::ibeta_inv(k, n - k + 1, alpha / 2);
    const double high = hits == samples ? 1 : boost::math::ibetac_inv(k + 1, n - k, alpha / 2);
    return {std::max(0.0, low * (1 - outward)), std::min(1.0, high * (1 + outward))};
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

}  // namespace robochart::markov
