// Iterated racing: which values of parameters do best in trials of which none tells much (López-Ibáñez et al., "The
// irace package", 2016). In each iteration candidates are drawn, near those that were best before; all run on the same
// seeds, and those that do worse than the best, as far as a test can tell, leave. Elitist: a candidate that was best
// before leaves only when others have run on as many seeds.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "simulation/tuning/space.hpp"

namespace robochart::simulation {

/// How it is found that one candidate is worse than another, on the same seeds, each at an error of 5 %.
enum class Elimination {
    friedman,  ///< Friedman's test of all, then differences of rank sums from the best; of two, Wilcoxon's
    t_test     ///< Student's test of pairs, against the candidate with the lowest mean
};

/// How a search is run; its results depend on nothing else, and on the costs.
struct RaceOptions {
    std::uint64_t budget = 1000;  ///< trials
    std::uint64_t seed = 1;       ///< of what is drawn
    Elimination elimination = Elimination::friedman;
};

/// A candidate on the seed of this number, from 0.
struct RaceTrial {
    std::size_t candidate = 0;
    std::uint64_t seed = 0;

    friend auto operator<=>(const RaceTrial&, const RaceTrial&) = default;
};

/// What the search asks of the world. Exceptions end it; what was found until then stays.
class RaceSubject {
public:
    virtual ~RaceSubject() = default;
    /// Can trials of it be run? Asked once for each candidate, in the order of their numbers from 0.
    virtual bool usable(const Candidate&) = 0;
    /// May it be among the best? Asked at most once for each, when it leads or would be among them.
    virtual bool admitted(const Candidate&) = 0;
    /// The costs of trials, in their order. Lower is better.
    virtual std::vector<double> costs(const std::vector<RaceTrial>&) = 0;
};

/// What is known of a candidate.
struct RaceEntry {
    Candidate candidate;
    Neighbourhood near;
    bool usable = true;
    std::vector<std::optional<double>> costs;  ///< on each seed

    [[nodiscard]] std::uint64_t trials() const;
    /// Over its trials.
    [[nodiscard]] double mean() const;
};

/// One iteration as it went.
struct RaceIteration {
    std::uint64_t fresh = 0;     ///< candidates drawn anew
    std::uint64_t unusable = 0;  ///< of these
    std::uint64_t seeds = 0;     ///< on which those that were left have run
    std::uint64_t trials = 0;
    std::uint64_t left = 0;     ///< candidates
    std::uint64_t refused = 0;  ///< of those that led, or would have been among the best
};

class Race {
public:
    /// Keeps references. At least one parameter.
    Race(const std::vector<Parameter>&, const RaceOptions&, RaceSubject&);

    /// Until the budget does not suffice for another iteration, or nothing new is to be drawn. `watch` is called after
    /// each iteration.
    void run(const std::function<void(const Race&)>& watch = {});

    [[nodiscard]] const std::vector<RaceEntry>& entries() const { return entries_; }
    /// The best first, by their numbers; at most 2 + log2(parameters) of them.
    [[nodiscard]] const std::vector<std::size_t>& elites() const { return elites_; }
    [[nodiscard]] const std::vector<RaceIteration>& iterations() const { return iterations_; }
    [[nodiscard]] std::uint64_t trials() const { return trials_; }
    [[nodiscard]] std::uint64_t seeds() const { return seeds_; }

private:
    static constexpr std::uint64_t first_test = 5;

    [[nodiscard]] std::uint64_t survivors() const;
    [[nodiscard]] std::uint64_t planned_iterations() const;
    bool iterate();
    std::vector<std::size_t> sample(std::uint64_t fresh, double progress);
    RaceEntry near_an_elite();
    void compete(std::vector<std::size_t> alive, std::uint64_t share);
    [[nodiscard]] std::uint64_t missing(const std::vector<std::size_t>& alive, std::uint64_t seed) const;
    void look(const std::vector<std::size_t>& alive, const std::vector<std::uint64_t>& seeds);
    [[nodiscard]] std::vector<std::size_t> ranked(std::vector<std::size_t> alive,
                                                  const std::vector<std::uint64_t>& seeds) const;
    [[nodiscard]] std::vector<std::size_t> not_worse(const std::vector<std::size_t>& alive,
                                                     const std::vector<std::uint64_t>& seeds) const;
    bool lead(std::vector<std::size_t>& alive, const std::vector<std::uint64_t>& seeds);
    bool is_admitted(std::size_t candidate);
    void choose(const std::vector<std::size_t>& best);

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
