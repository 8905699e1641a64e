// SPDX-License-Identifier: Apache-2.0
// Tests iterated racing on cost functions with known optima.
#include "simulation/tuning/race.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "base/diagnostics/splitmix64.hpp"

namespace robochart::simulation {
namespace {

/// Returns a number in [0, 1) that depends only on the arguments.
double noise(std::uint64_t one, std::uint64_t other) {
    return static_cast<double>(diagnostics::splitmix64_mixed(one * 0x9e3779b97f4a7c15U + other) >> 11U) * 0x1.0p-53;
}

/// A subject whose cost is a function of the values and of the seed.
class Synthetic : public RaceSubject {
public:
    explicit Synthetic(std::vector<Parameter> parameters) : parameters_(std::move(parameters)) {}

    bool is_usable(const Candidate& candidate) override {
        candidates_.push_back(candidate);
        return can_run(candidate);
    }
    bool admits_candidate(const Candidate& candidate) override {
        ++asked_;
        return is_admitted(candidate);
    }
    std::vector<double> trial_costs(const std::vector<RaceTrial>& trials) override {
        std::vector<double> result;
        for (const RaceTrial& trial : trials) {
            EXPECT_TRUE(run_.insert(trial).second) << "run once";
            EXPECT_TRUE(can_run(candidates_[trial.candidate]));
            if (run_.size() > most_) throw std::runtime_error("ended");
            // The noise of the seed is common to all candidates. A smaller noise is individual.
            result.push_back(cost(candidates_[trial.candidate]) + 10 * noise(trial.seed, 0) +
                             noise(trial.seed, trial.candidate + 1));
        }
        return result;
    }
    virtual bool can_run(const Candidate&) { return true; }
    virtual bool is_admitted(const Candidate&) { return true; }
    virtual double cost(const Candidate& candidate) {
        const double x = number(candidate, 0) - 0.3;
        return 5 * x * x;
    }
    double number(const Candidate& candidate, std::size_t p) const {
        return std::stod(parameters_[p].value_text(candidate[p]));
    }

    std::vector<Parameter> parameters_;
    std::vector<Candidate> candidates_;
    std::set<RaceTrial> run_;
    std::size_t most_ = 1'000'000;
    int asked_ = 0;
};

Parameter parameter(const std::string& text, ParameterKind kind = ParameterKind::real) {
    std::string error;
    return read_parameter("x", text, kind, error).value();
}

/// Returns the best value that a search finds.
double best(Synthetic& subject, const RaceOptions& options, std::size_t p = 0) {
    Race race(subject.parameters_, options, subject);
    race.run();
    EXPECT_LE(race.trial_count(), options.budget);
    EXPECT_EQ(race.trial_count(), subject.run_.size());
    EXPECT_FALSE(race.elites().empty());
    return subject.number(race.entries()[race.elites().front()].candidate, p);
}

/// The noise of a seed is twenty times the cost difference over half the range, but it cancels on common seeds. A
/// candidate 0.1 off costs 0.05 more, an eighth of the standard deviation of the remaining noise.
TEST(Race, FindsTheLowestOfAParabola) {
    for (const Elimination test : {Elimination::friedman, Elimination::t_test})
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            Synthetic subject({parameter("0.0..1.0")});
            EXPECT_NEAR(best(subject, {2000, seed, test}), 0.3, 0.15) << seed;
        }
}

TEST(Race, MixedParameters) {
    class Mixed : public Synthetic {
        using Synthetic::Synthetic;
        double cost(const Candidate& c) override {
            return 5 * std::abs(number(c, 0) - 0.3) + 0.3 * std::abs(number(c, 1) - 7) + (c[2] == 1 ? 0 : 1);
        }
    };
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Mixed subject({parameter("0.0..1.0"), parameter("0..20", ParameterKind::whole),
                       parameter("p,q,r", ParameterKind::other)});
        Race race(subject.parameters_, {3000, seed, Elimination::friedman}, subject);
        race.run();
        const Candidate& winner = race.entries()[race.elites().front()].candidate;
        EXPECT_NEAR(subject.number(winner, 0), 0.3, 0.1) << seed;
        EXPECT_NEAR(subject.number(winner, 1), 7, 2) << seed;
        EXPECT_EQ(winner[2], 1U) << seed;
    }
}

TEST(Race, WhatIsRefusedIsNotAmongTheBest) {
    class Refusing : public Synthetic {
        using Synthetic::Synthetic;
        bool is_admitted(const Candidate& c) override { return number(c, 0) >= 0.5; }
    };
    Refusing subject({parameter("0.0..1.0")});
    const double found = best(subject, {2000, 1, Elimination::friedman});
    EXPECT_GE(found, 0.5);
    EXPECT_LE(found, 0.7);
    EXPECT_GT(subject.asked_, 0);
}

TEST(Race, NothingIsAdmitted) {
    class Refusing : public Synthetic {
        using Synthetic::Synthetic;
        bool is_admitted(const Candidate&) override { return false; }
    };
    Refusing subject({parameter("0.0..1.0")});
    Race race(subject.parameters_, {500, 1, Elimination::friedman}, subject);
    race.run();
    EXPECT_TRUE(race.elites().empty());
    EXPECT_LE(race.trial_count(), 500U);
}

TEST(Race, WhatCannotRunIsNotRun) {
    class Half : public Synthetic {
        using Synthetic::Synthetic;
        bool can_run(const Candidate& c) override { return number(c, 0) < 0.2; }
    };
    Half subject({parameter("0.0..1.0")});
    EXPECT_NEAR(best(subject, {1000, 1, Elimination::friedman}), 0.2, 0.1);
    Half none({parameter("0.5..1.0")});
    Race race(none.parameters_, {1000, 1, Elimination::friedman}, none);
    race.run();
    EXPECT_EQ(race.trial_count(), 0U);
    EXPECT_TRUE(race.elites().empty());
}

/// The space has only four candidates.
TEST(Race, SmallSpacesEnd) {
    class Four : public Synthetic {
        using Synthetic::Synthetic;
        double cost(const Candidate& c) override { return c[0] == 1 && c[1] == 0 ? 0 : 3; }
    };
    Four subject({parameter("p,q", ParameterKind::other), parameter("p,q", ParameterKind::other)});
    Race race(subject.parameters_, {1000, 1, Elimination::friedman}, subject);
    race.run();
    EXPECT_EQ(race.entries().size(), 4U);
    EXPECT_EQ(race.entries()[race.elites().front()].candidate, (Candidate{1, 0}));
}

TEST(Race, BudgetsThatAreTooSmall) {
    for (const std::uint64_t budget : {1U, 5U, 11U}) {
        Synthetic subject({parameter("0.0..1.0")});
        Race race(subject.parameters_, {budget, 1, Elimination::friedman}, subject);
        race.run();
        EXPECT_LE(race.trial_count(), budget);
    }
}

TEST(Race, TheSameSeedFindsTheSame) {
    const auto found = [](std::uint64_t seed) {
        Synthetic subject({parameter("0.0..1.0")});
        Race race(subject.parameters_, {800, seed, Elimination::friedman}, subject);
        race.run();
        return std::pair(subject.candidates_, subject.run_);
    };
    EXPECT_EQ(found(3), found(3));
    EXPECT_NE(found(3), found(4));
}

TEST(Race, WhatWasFoundStaysWhereItIsEnded) {
    Synthetic subject({parameter("0.000..1.000")});
    subject.most_ = 1300;
    Race race(subject.parameters_, {2000, 1, Elimination::friedman}, subject);
    EXPECT_THROW(race.run(), std::runtime_error);
    ASSERT_FALSE(race.elites().empty());
    EXPECT_LE(race.trial_count(), 1300U);
    EXPECT_NEAR(subject.number(race.entries()[race.elites().front()].candidate, 0), 0.3, 0.3);
}

}  // namespace
}  // namespace robochart::simulation
