// SPDX-License-Identifier: Apache-2.0
// Finds the parameter values that do best in noisy trials, by iterated racing (López-Ibáñez et al., "The irace
// package", 2016). In each iteration, candidates are drawn near the best ones so far. All run on the same seeds, and
// candidates that are significantly worse than the best are eliminated. The race is elitist: an elite can be eliminated
// only after the other candidates have run on the same number of seeds.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "simulation/tuning/space.hpp"

namespace robochart::simulation {

/// The test that decides whether a candidate is worse than another on the same seeds, at an error of 5 %.
enum class Elimination {
    friedman,  ///< Friedman's test of all, then differences of rank sums from the best; for two candidates, Wilcoxon's
    t_test     ///< paired t-test against the candidate with the lowest mean
};

/// Options of a search. The results of a search depend only on these options and on the costs.
struct RaceOptions {
    std::uint64_t budget = 1000;  ///< number of trials
    std::uint64_t seed = 1;       ///< the seed of the random choices
    Elimination elimination = Elimination::friedman;
};

/// A trial of a candidate: the candidate, and the index of the seed, from 0.
struct RaceTrial {
    std::size_t candidate = 0;
    std::uint64_t seed = 0;

    friend auto operator<=>(const RaceTrial&, const RaceTrial&) = default;
};

/// Runs the trials for the search. If a function throws, the search ends, and the results so far remain available.
class RaceSubject {
public:
    virtual ~RaceSubject() = default;
    /// True if trials of the candidate can be run. Called once for each candidate, in order of index.
    virtual bool is_usable(const Candidate&) = 0;
    /// True if the candidate may be among the best. Called at most once for each candidate, when the candidate is the
    /// best or would become one of the best.
    virtual bool admits_candidate(const Candidate&) = 0;
    /// Runs the trials and returns their costs, in order. Lower is better.
    virtual std::vector<double> trial_costs(const std::vector<RaceTrial>&) = 0;
};

/// The data about a candidate.
struct RaceEntry {
    Candidate candidate;
    Neighbourhood near;
    bool usable = true;
    std::vector<std::optional<double>> costs;  ///< the cost for each seed; no value if no trial ran

    [[nodiscard]] std::uint64_t trial_count() const;
    /// Returns the mean cost of the candidate's trials.
    [[nodiscard]] double mean_cost() const;
};

/// A record of one iteration.
struct RaceIteration {
    std::uint64_t fresh = 0;     ///< number of new candidates
    std::uint64_t unusable = 0;  ///< number of these candidates that were unusable
    std::uint64_t seeds = 0;     ///< number of seeds on which the remaining candidates have run
    std::uint64_t trials = 0;
    std::uint64_t left = 0;     ///< number of remaining candidates
    std::uint64_t refused = 0;  ///< number of candidates that were not admitted
};

class Race {
public:
    /// Stores references to the arguments. There must be at least one parameter.
    Race(const std::vector<Parameter>&, const RaceOptions&, RaceSubject&);

    /// Runs until the budget does not suffice for another iteration, or there are no new candidates. `watch` is called
    /// after each iteration.
    void run(const std::function<void(const Race&)>& watch = {});

    [[nodiscard]] const std::vector<RaceEntry>& entries() const { return entries_; }
    /// Returns the indices of the best candidates, best first; at most 2 + log2(parameters).
    [[nodiscard]] const std::vector<std::size_t>& elites() const { return elites_; }
    [[nodiscard]] const std::vector<RaceIteration>& iterations() const { return iterations_; }
    [[nodiscard]] std::uint64_t trial_count() const { return trials_; }
    [[nodiscard]] std::uint64_t seed_count() const { return seeds_; }

private:
    static constexpr std::uint64_t first_test = 5;

    [[nodiscard]] std::uint64_t survivor_count() const;
    [[nodiscard]] std::uint64_t planned_iterations() const;
    bool run_iteration();
    std::vector<std::size_t> sample_candidates(std::uint64_t fresh, double progress);
    RaceEntry near_an_elite();
    void run_competition(std::vector<std::size_t> alive, std::uint64_t share);
    [[nodiscard]] std::uint64_t missing_trials(const std::vector<std::size_t>& alive, std::uint64_t seed) const;
    void run_missing_trials(const std::vector<std::size_t>& alive, const std::vector<std::uint64_t>& seeds);
    [[nodiscard]] std::vector<std::size_t> rank_candidates(std::vector<std::size_t> alive,
                                                           const std::vector<std::uint64_t>& seeds) const;
    [[nodiscard]] std::vector<std::size_t> not_worse(const std::vector<std::size_t>& alive,
                                                     const std::vector<std::uint64_t>& seeds) const;
    bool find_admitted_leader(std::vector<std::size_t>& alive, const std::vector<std::uint64_t>& seeds);
    bool is_admitted(std::size_t candidate);
    void choose_elites(const std::vector<std::size_t>& best);

    const std::vector<Parameter>& parameters_;
    const RaceOptions& options_;
    RaceSubject& subject_;
    Random random_;
    std::vector<RaceEntry> entries_;
    std::set<Candidate> drawn_;
    std::set<std::size_t> admitted_, refused_;
    std::vector<std::size_t> elites_;
    std::vector<RaceIteration> iterations_;
    std::uint64_t trials_ = 0;
    std::uint64_t seeds_ = 0;
};

}  // namespace robochart::simulation
