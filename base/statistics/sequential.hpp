// SPDX-License-Identifier: Apache-2.0
// Evaluates trials that stop as soon as the evidence is sufficient. It contains Wald's test ("Sequential tests of
// statistical hypotheses", Annals of Mathematical Statistics 16, 1945), and intervals of Clopper and Pearson at several
// looks that share the error.
#pragma once

#include <cstdint>
#include <optional>

#include "base/statistics/binomial.hpp"

namespace robochart::statistics {

/// Wald's sequential probability ratio test of "the probability is at least p0" against "it is at most p1".
struct Sprt {
    double p0 = 0;  ///< 0 < p1 < p0 < 1
    double p1 = 0;
    double alpha = 0;  ///< upper bound on the chance of the answer `below` if the probability is at least p0
    double beta = 0;   ///< upper bound on the chance of the answer `at_least` if the probability is at most p1

    enum class Answer { open, at_least, below };
    /// Returns the answer after this many trials. It must be called after each trial, in order. The first answer that
    /// is not open is the result of the test.
    ///
    /// The likelihood ratio of p1 to p0 is compared with 1/alpha and beta instead of Wald's (1 - beta)/alpha and
    /// beta/(1 - alpha), because Wald's bounds on the errors are only exact without overshoot. By Ville's inequality,
    /// the ratio ever exceeds 1/alpha with a chance of at most alpha at p0. Above p0 the chance is smaller, because the
    /// ratio is stochastically smaller. In the same way, the inverse of the ratio exceeds 1/beta with a chance of at
    /// most beta at p1.
    [[nodiscard]] Answer answer(std::uint64_t successes, std::uint64_t trials) const;
};

/// Computes a confidence interval that may be examined while trials continue. Look k takes place after 16 * 1.5^(k-1)
/// trials and uses error / (k (k + 1)). The last look, after `most` trials, uses the rest, so all looks together use
/// `error`. The chance that any of the intervals does not contain the true probability is therefore at most `error`,
/// and trials may stop at any look.
class Looks {
public:
    /// `most` is the maximal number of trials, at least 1.
    Looks(std::uint64_t most, double error) : most_(most), error_(error) {}

    /// Returns the number of trials at the first look after `trials` trials. Returns no value after the last look.
    [[nodiscard]] std::optional<std::uint64_t> trials_of_next_look(std::uint64_t trials) const;
    /// Returns the interval of the look after exactly `trials` trials. Returns no value if there is no look.
    [[nodiscard]] std::optional<Interval> interval_after(std::uint64_t successes, std::uint64_t trials) const;
    /// Returns the part of the error that the look after `trials` trials uses, or 0 if there is no look.
    [[nodiscard]] double error_share(std::uint64_t trials) const;

private:
    struct Look {
        std::uint64_t number = 0;
        std::uint64_t trials = 0;
    };
    /// Returns the first look after at least `trials` trials, or the last look if there is none.
    [[nodiscard]] Look look_from(std::uint64_t trials) const;

    std::uint64_t most_;
    double error_;
};

}  // namespace robochart::statistics
