// Statistics of trials that end as soon as they have said enough: Wald, "Sequential tests of statistical hypotheses",
// Annals of Mathematical Statistics 16, 1945; and intervals of Clopper and Pearson at several looks that share the
// error.
#pragma once

#include <cstdint>
#include <optional>

#include "statistics/binomial.hpp"

namespace robochart::statistics {

/// Wald's sequential probability ratio test of "the probability is at least p0" against "it is at most p1".
struct Sprt {
    double p0 = 0;  ///< 0 < p1 < p0 < 1
    double p1 = 0;
    double alpha = 0;  ///< the chance of `below` where the probability is at least p0 is at most this
    double beta = 0;   ///< the chance of `at_least` where it is at most p1 is at most this

    enum class Answer { open, at_least, below };
    /// To be asked after each trial, in order; the first answer that is not open is that of the test.
    ///
    /// The likelihood ratio of p1 to p0 is compared with 1/alpha and beta instead of Wald's (1 - beta)/alpha and
    /// beta/(1 - alpha), which hold but for the overshoot: by Ville's inequality it ever passes 1/alpha with a chance
    /// of at most alpha at p0, and less above p0, where it is stochastically smaller; and its inverse likewise 1/beta
    /// at p1.
    [[nodiscard]] Answer answer(std::uint64_t successes, std::uint64_t trials) const;
};

/// A confidence interval that may be looked at while trials go on. Look k is after 16 * 1.5^(k-1) trials and takes
/// error / (k (k + 1)) of the error, the last one, after `most` trials, all that is left: together `error`. So the
/// chance that any of them misses the true probability is at most `error`, and trials may end at any look.
class Looks {
public:
    /// `most` trials at most, at least one.
    Looks(std::uint64_t most, double error) : most_(most), error_(error) {}

    /// The number of trials of the next look after so many; none after the last.
    [[nodiscard]] std::optional<std::uint64_t> next(std::uint64_t trials) const;
    /// The interval of the look after so many trials; between looks there is none.
    [[nodiscard]] std::optional<Interval> at(std::uint64_t successes, std::uint64_t trials) const;
    /// Of the error, what the look after so many trials takes; 0 between looks.
    [[nodiscard]] double share(std::uint64_t trials) const;

private:
    struct Look {
        std::uint64_t number = 0;
        std::uint64_t trials = 0;
    };
    /// The first look after at least so many trials; `most_` for more.
    [[nodiscard]] Look first(std::uint64_t trials) const;

    std::uint64_t most_;
    double error_;
};

}  // namespace robochart::statistics
