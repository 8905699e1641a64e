// SPDX-License-Identifier: Apache-2.0
// Computes exact probabilities of sequential procedures. From trial to trial, the tests carry the distribution of the
// number of successes among undecided runs; decided runs leave this distribution.
#include "base/statistics/sequential.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <numeric>
#include <vector>

namespace robochart::statistics {
namespace {

/// The outcome of a procedure of at most `most` trials if each trial succeeds with probability p. `stops` decides
/// whether the procedure ends after this many trials with this many successes. It returns the entry of `counted` to
/// which the outcome belongs.
struct Outcome {
    double counted[2] = {0, 0};
    double mean_trials = 0;
};
using Stops = std::function<int(std::uint64_t successes, std::uint64_t trials)>;  // -1: continues

Outcome run(std::uint64_t most, double p, const Stops& stops) {
    Outcome outcome;
    std::vector<double> chance{1};
    for (std::uint64_t trials = 1; trials <= most; ++trials) {
        const double left = std::accumulate(chance.begin(), chance.end(), 0.0);
        if (left < 1e-12) break;
        outcome.mean_trials += left;
        std::vector<double> next(chance.size() + 1);
        for (std::size_t x = 0; x < chance.size(); ++x) {
            next[x] += chance[x] * (1 - p);
            next[x + 1] += chance[x] * p;
        }
        for (std::size_t x = 0; x < next.size(); ++x) {
            const int stopped = next[x] > 0 ? stops(x, trials) : -1;
            if (stopped < 0) continue;
            outcome.counted[stopped] += next[x];
            next[x] = 0;
        }
        chance = std::move(next);
    }
    return outcome;
}

Outcome run(const Sprt& test, std::uint64_t most, double p) {
    return run(most, p, [&](std::uint64_t x, std::uint64_t n) {
        const Sprt::Answer answer = test.answer(x, n);
        if (answer == Sprt::Answer::open) return -1;
        return answer == Sprt::Answer::at_least ? 0 : 1;
    });
}

TEST(Sprt, ErrsAtMostAsOftenAsItSays) {
    for (const Sprt& test : {Sprt{0.95, 0.90, 0.01, 0.01}, Sprt{0.5, 0.4, 0.05, 0.01}, Sprt{0.1, 0.02, 0.01, 0.1}}) {
        for (const double p : {test.p0, (1 + test.p0) / 2, 0.999}) EXPECT_LE(run(test, 3000, p).counted[1], test.alpha);
        for (const double p : {test.p1, test.p1 / 2, 0.001}) EXPECT_LE(run(test, 3000, p).counted[0], test.beta);
        // The test uses at least a third of the permitted error. A test that never answers would pass the assertions
        // above, but not these.
        EXPECT_GE(run(test, 3000, test.p0).counted[1], test.alpha / 3);
        EXPECT_GE(run(test, 3000, test.p1).counted[0], test.beta / 3);
        EXPECT_GE(run(test, 3000, test.p0).counted[0], 1 - test.alpha - 1e-3);
    }
}

/// Wald's approximation of the mean number of trials, which ignores the overshoot. At p0 and p1 it is (P(at_least)
/// ln(beta) + P(below) ln(1/alpha)) divided by the mean step of the log-likelihood ratio. At 1 it is rounded to whole
/// steps.
TEST(Sprt, IsAsLongAsWaldSays) {
    const Sprt test{0.95, 0.90, 0.01, 0.01};
    EXPECT_NEAR(run(test, 5000, 0.80).mean_trials, 48, 4.8);
    EXPECT_NEAR(run(test, 5000, 0.90).mean_trials, 218, 21.8);
    EXPECT_NEAR(run(test, 5000, 0.925).mean_trials, 547, 54.7);
    EXPECT_NEAR(run(test, 5000, 0.95).mean_trials, 270, 27.0);
    EXPECT_EQ(run(test, 5000, 1).mean_trials, 86);  // the first n with n ln(.95/.90) >= ln 100
}

TEST(Looks, AreAtTheirTimes) {
    const Looks looks(100, 0.05);
    std::vector<std::uint64_t> times;
    for (auto next = looks.trials_of_next_look(0); next; next = looks.trials_of_next_look(*next))
        times.push_back(*next);
    EXPECT_EQ(times, (std::vector<std::uint64_t>{16, 24, 36, 54, 81, 100}));
    EXPECT_EQ(looks.interval_after(5, 17), std::nullopt);
    // The first look uses half of the error, and the second a sixth. The last look uses the remainder, which is 1/6 for
    // six looks.
    EXPECT_EQ(looks.interval_after(9, 16), clopper_pearson(9, 16, 0.05 / 2));
    EXPECT_EQ(looks.interval_after(9, 24), clopper_pearson(9, 24, 0.05 / 6));
    EXPECT_EQ(looks.interval_after(90, 100), clopper_pearson(90, 100, 0.05 / 6));
    // 1/2 + 1/6 + 1/12 + 1/20 + 1/30 + 1/6 = 1.
    EXPECT_EQ(Looks(1, 0.05).interval_after(1, 1), clopper_pearson(1, 1, 0.05));
    EXPECT_EQ(Looks(1, 0.05).trials_of_next_look(1), std::nullopt);
}

/// The probability that at least one look has an interval that misses the true value.
TEST(Looks, TogetherMissAtMostAsOftenAsTheySay) {
    for (const std::uint64_t most : {10U, 100U, 1000U}) {
        const Looks looks(most, 0.05);
        for (const double p : {0.01, 0.05, 0.3, 0.5, 0.95, 0.99}) {
            const double missed = run(most, p, [&](std::uint64_t x, std::uint64_t n) {
                                      const auto interval = looks.interval_after(x, n);
                                      return interval && (p < interval->low || p > interval->high) ? 0 : -1;
                                  }).counted[0];
            EXPECT_LE(missed, 0.05) << most << " trials, p = " << p;
        }
    }
    // The test above is not vacuous. Near one half, about a tenth of the error is used, because looks are discrete and
    // dependent.
    const Looks looks(1000, 0.05);
    const double missed = run(1000, 0.5, [&](std::uint64_t x, std::uint64_t n) {
                              const auto interval = looks.interval_after(x, n);
                              return interval && (0.5 < interval->low || 0.5 > interval->high) ? 0 : -1;
                          }).counted[0];
    EXPECT_GE(missed, 0.005);
}

}  // namespace
}  // namespace robochart::statistics
