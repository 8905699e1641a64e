// SPDX-License-Identifier: Apache-2.0
// Implements simulation.hpp. The formulas of the methods are those of PRISM's manual.
#include "prism/session/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/statistics/binomial.hpp"
#include "base/statistics/means.hpp"
#include "base/statistics/sequential.hpp"
#include "prism/explore/constants.hpp"
#include "prism/explore/question_numbers.hpp"
#include "prism/sampling/sampler.hpp"
#include "prism/sampling/unsampled.hpp"
#include "prism/session/labels.hpp"

namespace robochart::prism {
namespace {

using Kind = Method::Kind;

constexpr std::uint64_t usual_samples = 1000;
constexpr double usual_alpha = 0.01;
constexpr double usual_indifference = 0.05;
/// The least number of samples for an interval. With fewer samples the variance is unreliable and may be 0 by chance.
constexpr std::uint64_t least_samples = 1000;
constexpr std::uint64_t any_number = std::numeric_limits<std::uint64_t>::max();

/// Returns the number of samples that the method fixes in advance, or `any_number` if it decides during sampling.
std::uint64_t samples_of(const Method& method) {
    if (method.kind == Kind::sprt) return any_number;
    if (method.samples || !method.width) return method.samples.value_or(usual_samples);
    if (method.kind != Kind::apmc) return any_number;
    const double samples = statistics::hoeffding_samples(*method.width, method.confidence.value_or(usual_alpha));
    return samples < 1e18 ? static_cast<std::uint64_t>(std::max(1.0, samples)) : any_number;
}

class Simulation {
public:
    Simulation(const Instance& instance, const ExprPtr& question, const Values& constants,
               const SamplingOptions& options)
        : question_(*question),
          method_(options.method),
          probability_(question->op == Op::probability),
          code_(instance.code(constants)),
          most_(samples_of(method_)),
          sampler_(instance, *question, constants, most_, options) {
        if (question_.query->bound) bound_ = bound_of(question_, code_);
        if (method_.kind == Kind::apmc && !probability_) throw Unsampled("apmc estimates probabilities, not rewards");
        if (method_.kind == Kind::sprt && !(probability_ && bound_))
            throw Unsampled("sprt decides a bound on a probability, such as P>=0.9 [ ... ]");
    }

    Result operator()() {
        if (method_.kind == Kind::sprt) return sequential();
        while (values_.count() < most_ && !(most_ == any_number && narrow_enough())) take_sample();
        return bound_ ? compare_with_bound() : mean_result();
    }

    void report(diagnostics::Diagnostics& diagnostics) const { sampler_.report(diagnostics); }

private:
    /// Takes a sample; throws Unsampled if the path is undecided.
    double take_sample() {
        const Sample sample = sampler_.next_sample();
        if (!sample.decided)
            throw Unsampled(fmt::format("path {} is open after {} steps (path={})", values_.count() + 1, sample.steps,
                                        method_.path));
        least_steps_ = std::min(least_steps_, sample.steps);
        most_steps_ = std::max(most_steps_, sample.steps);
        steps_ += static_cast<double>(sample.steps);
        endless_ = endless_ || std::isinf(sample.value);
        values_.add(std::isinf(sample.value) ? 0 : sample.value);
        if (sample.value > 0) ++hits_;
        return sample.value;
    }

    [[nodiscard]] double alpha() const { return method_.confidence.value_or(usual_alpha); }

    /// Returns half the width of the interval in standard deviations.
    [[nodiscard]] double quantile(double alpha) const {
        if (method_.kind == Kind::aci) return statistics::normal_quantile(alpha / 2);
        return values_.count() < 2 ? std::numeric_limits<double>::infinity()
                                   : statistics::student_quantile(alpha / 2, values_.count() - 1);
    }

    /// Returns whether N >= v t^2 / w^2. The test first uses the known quantile of the normal distribution, which is
    /// less than Student's quantile.
    [[nodiscard]] bool narrow_enough() const {
        const double error = values_.standard_error();
        return values_.count() >= least_samples && normal_ * error <= *method_.width &&
               quantile(alpha()) * error <= *method_.width;
    }

    /// Returns the estimate so far. Any two of samples, width and confidence determine the third.
    [[nodiscard]] Estimate estimate() const {
        Estimate result;
        result.method = method_.kind;
        result.samples = values_.count();
        result.mean = endless_ ? std::numeric_limits<double>::infinity() : values_.mean();
        result.alpha = alpha();
        result.mean_steps = steps_ / static_cast<double>(values_.count());
        result.least_steps = least_steps_;
        result.most_steps = most_steps_;
        if (method_.kind != Kind::sprt) interval(result);
        if (probability_) {
            result.hits = hits_;
            result.binomial = statistics::clopper_pearson(hits_, values_.count(), result.alpha);
        }
        return result;
    }

    void interval(Estimate& result) const {
        const auto count = static_cast<double>(values_.count());
        const double error = values_.standard_error();
        const bool given = method_.width && method_.samples;
        if (method_.kind == Kind::apmc) {
            result.width = given ? *method_.width : statistics::hoeffding_epsilon(count, result.alpha);
            if (given) result.alpha = statistics::hoeffding_delta(count, *method_.width);
        } else if (values_.count() < 2) {
            // One sample gives no information about the deviation.
            result.width = std::numeric_limits<double>::infinity();
        } else if (given) {
            result.width = method_.width;
            result.alpha = error > 0 ? std::clamp(2 * tail(*method_.width / error), least_alpha, 1.0) : least_alpha;
        } else {
            result.width = error > 0 ? quantile(result.alpha) * error : 0;
        }
    }

    /// Returns the probability that a value is at least this many standard deviations above the mean.
    [[nodiscard]] double tail(double deviations) const {
        return method_.kind == Kind::aci ? statistics::normal_tail(deviations)
                                         : statistics::student_tail(deviations, values_.count() - 1);
    }

    Result with_estimate() const {
        Result result;
        result.estimate = estimate();
        return result;
    }

    Result mean_result() const {
        Result result = with_estimate();
        result.kind = Result::Kind::number;
        result.type = Type::real;
        result.low = result.high = probability_ ? Real(Rational(hits_, values_.count()))
                                                : Real(Enclosure{result.estimate->mean, result.estimate->mean});
        return result;
    }

    Result truth_result(bool above) const {
        Result result = with_estimate();
        const Op relation = question_.query->relation;
        result.kind = Result::Kind::truth;
        result.truth = above == (relation == Op::greater || relation == Op::greater_equal);
        return result;
    }

    /// Compares the result with a bound. One path decides in three cases. If the formula holds on a path, the
    /// probability is not 0. If it does not hold, the probability is not 1. If a path never reaches the target, the
    /// reward is infinite. All other results depend on the intervals.
    Result compare_with_bound() const {
        const double bound = bound_->bounds().middle();
        if (endless_) return truth_result(true);
        if (probability_ && bound == 0 && hits_ > 0) return truth_result(true);
        if (probability_ && bound == 1 && hits_ < values_.count()) return truth_result(false);
        const Estimate found = estimate();
        double low = found.mean - *found.width;
        double high = found.mean + *found.width;
        if (found.binomial) {
            low = std::min(low, found.binomial->low);
            high = std::max(high, found.binomial->high);
        }
        if (low > bound || high < bound) return truth_result(low > bound);
        Result result = with_estimate();
        result.reason = fmt::format("the bound {} lies between {:.6g} and {:.6g}: more samples may decide",
                                    bound_->text(), low, high);
        return result;
    }

    Result sequential() {
        const double bound = bound_->bounds().middle();
        const double indifference = method_.width.value_or(usual_indifference);
        if (!(bound - indifference > 0 && bound + indifference < 1))
            throw Unsampled(
                fmt::format("sprt compares {:.6g} with {:.6g}, which must lie between 0 and 1: "
                            "choose a smaller width",
                            bound - indifference, bound + indifference));
        const statistics::Sprt test{bound + indifference, bound - indifference, alpha(), alpha()};
        auto answer = statistics::Sprt::Answer::open;
        while (answer == statistics::Sprt::Answer::open) {
            take_sample();
            answer = test.answer(hits_, values_.count());
        }
        return truth_result(answer == statistics::Sprt::Answer::at_least);
    }

    static constexpr double least_alpha = 1e-15;

    const Expr& question_;
    const Method& method_;
    const bool probability_;
    Code code_;
    const std::uint64_t most_;
    const double normal_ = statistics::normal_quantile(alpha() / 2);
    Sampler sampler_;
    std::optional<Real> bound_;
    statistics::Moments values_;
    bool endless_ = false;
    std::uint64_t hits_ = 0;
    double steps_ = 0;
    std::uint64_t least_steps_ = any_number, most_steps_ = 0;
};

}  // namespace

Result simulate(const Instance& instance, const CheckedProperties& properties, std::size_t property,
                const Values& constants, const SamplingOptions& options, diagnostics::Diagnostics& diagnostics) {
    Values known = instance.constants();
    evaluate_constants(properties.constants, constants, known, true);
    const ExprPtr question = LabelResolver(instance.model(), properties)(properties.properties[property].expression);
    try {
        Simulation simulation(instance, question, known, options);
        Result result = simulation();
        simulation.report(diagnostics);
        return result;
    } catch (const Unsampled& why) {
        Result result;
        result.reason = why.what();
        return result;
    }
}

}  // namespace robochart::prism
