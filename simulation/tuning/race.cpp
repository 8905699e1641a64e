// SPDX-License-Identifier: Apache-2.0
// See race.hpp. The numbers of candidates, trials and seeds follow sections 3.1 to 3.3 of the paper.
#include "simulation/tuning/race.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/statistics/blocks.hpp"

namespace robochart::simulation {

namespace {

/// The error of each elimination test.
constexpr double elimination_error = 0.05;

/// Returns the costs of candidates on seeds; each seed is a block.
std::vector<statistics::Block> blocks_of(const std::vector<RaceEntry>& entries, const std::vector<std::size_t>& alive,
                                         const std::vector<std::uint64_t>& seeds) {
    std::vector<statistics::Block> blocks;
    for (const std::uint64_t seed : seeds) {
        blocks.emplace_back();
        for (const std::size_t candidate : alive) blocks.back().push_back(entries[candidate].costs[seed].value());
    }
    return blocks;
}

/// Returns, for each candidate, the sum of its ranks or of its costs.
std::vector<double> sum_by_candidate(const std::vector<statistics::Block>& blocks, bool by_ranks) {
    std::vector<double> sums(blocks.front().size());
    for (const statistics::Block& block : blocks) {
        const std::vector<double> values = by_ranks ? statistics::mean_ranks(block) : block;
        for (std::size_t c = 0; c < sums.size(); ++c) sums[c] += values[c];
    }
    return sums;
}

std::vector<double> cost_differences(const std::vector<statistics::Block>& blocks, std::size_t one, std::size_t other) {
    std::vector<double> result;
    for (const statistics::Block& block : blocks) result.push_back(block[one] - block[other]);
    return result;
}

/// True for each candidate that the test cannot distinguish from the best.
std::vector<bool> kept_by_ranks(const std::vector<statistics::Block>& blocks) {
    const std::size_t candidates = blocks.front().size();
    const statistics::Friedman found = statistics::friedman_test(blocks);
    std::vector<bool> remains(candidates, true);
    const auto best = static_cast<std::size_t>(std::ranges::min_element(found.sums) - found.sums.begin());
    if (candidates == 2) {
        remains[1 - best] = statistics::signed_rank(cost_differences(blocks, 1 - best, best)) >= elimination_error;
        return remains;
    }
    if (found.chance >= elimination_error) return remains;
    const double most = found.critical_difference(elimination_error);
    for (std::size_t c = 0; c < candidates; ++c) remains[c] = found.sums[c] - found.sums[best] <= most;
    return remains;
}

std::vector<bool> kept_by_means(const std::vector<statistics::Block>& blocks) {
    const std::vector<double> sums = sum_by_candidate(blocks, false);
    const auto best = static_cast<std::size_t>(std::ranges::min_element(sums) - sums.begin());
    std::vector<bool> remains(sums.size(), true);
    for (std::size_t c = 0; c < sums.size(); ++c)
        remains[c] = c == best || statistics::paired_t(cost_differences(blocks, c, best)) >= elimination_error;
    return remains;
}

}  // namespace

std::uint64_t RaceEntry::trial_count() const {
    return static_cast<std::uint64_t>(std::ranges::count_if(costs, [](const auto& cost) { return cost.has_value(); }));
}

double RaceEntry::mean_cost() const {
    double sum = 0;
    for (const auto& cost : costs) sum += cost.value_or(0);
    return sum / static_cast<double>(std::max<std::uint64_t>(1, trial_count()));
}

Race::Race(const std::vector<Parameter>& parameters, const RaceOptions& options, RaceSubject& subject)
    : parameters_(parameters), options_(options), subject_(subject), random_(options.seed) {}

std::uint64_t Race::planned_iterations() const {
    return 2 + static_cast<std::uint64_t>(std::bit_width(parameters_.size()) - 1);
}

std::uint64_t Race::survivor_count() const {
    return planned_iterations();  // both are 2 + log2 of the number of parameters
}

void Race::run(const std::function<void(const Race&)>& watch) {
    while (run_iteration())
        if (watch) watch(*this);
}

/// Runs one iteration. Returns false if no iteration is possible.
bool Race::run_iteration() {
    const std::uint64_t left = options_.budget - std::min(trials_, options_.budget);
    const std::uint64_t number = iterations_.size() + 1;
    const std::uint64_t planned = planned_iterations();
    const std::uint64_t share = left / (number < planned ? planned - number + 1 : 1);
    const std::uint64_t candidate_count = share / (first_test + std::min<std::uint64_t>(first_test, number));
    const std::uint64_t elites = elites_.size();
    // A race is useless if it has no more candidates than may survive.
    if (candidate_count <= std::max(elites, number == 1 ? std::uint64_t{1} : survivor_count())) return false;
    const double progress = std::min(1.0, static_cast<double>(number - 1) / static_cast<double>(planned));
    RaceIteration now;
    const std::vector<std::size_t> fresh = sample_candidates(candidate_count - elites, progress);
    now.fresh = fresh.size();
    iterations_.push_back(now);
    std::vector<std::size_t> alive = elites_;
    for (const std::size_t candidate : fresh) {
        entries_[candidate].usable = subject_.is_usable(entries_[candidate].candidate);
        if (entries_[candidate].usable)
            alive.push_back(candidate);
        else
            ++iterations_.back().unusable;
    }
    if (fresh.empty()) iterations_.pop_back();
    if (alive.size() == elites_.size()) return false;
    run_competition(std::move(alive), share);
    return true;
}

/// Draws new candidates, without duplicates: arbitrary ones in the first iteration, later ones near the best. If no new
/// candidate is found near the best, the neighbourhood grows. The result is smaller than requested if the space
/// contains no more candidates.
std::vector<std::size_t> Race::sample_candidates(std::uint64_t fresh, double progress) {
    for (const std::size_t elite : elites_)
        narrow_neighbourhood(entries_[elite].near, parameters_, entries_[elite].candidate, fresh, progress);
    constexpr int most_repeats = 100;
    constexpr int most_widenings = 20;
    std::vector<std::size_t> result;
    int repeats = 0;
    int widenings = 0;
    while (result.size() < fresh) {
        RaceEntry entry = elites_.empty()
                              ? RaceEntry{draw_candidate(parameters_, random_), whole_space(parameters_), true, {}}
                              : near_an_elite();
        if (!drawn_.insert(entry.candidate).second) {
            if (++repeats < most_repeats) continue;
            repeats = 0;
            for (const std::size_t elite : elites_) widen_neighbourhood(entries_[elite].near, parameters_);
            if (++widenings == most_widenings) break;
            continue;
        }
        repeats = 0;
        result.push_back(entries_.size());
        entries_.push_back(std::move(entry));
    }
    return result;
}

/// Draws a candidate near the elite of rank r of n with probability (n - r + 1) / (n (n + 1) / 2).
RaceEntry Race::near_an_elite() {
    const std::uint64_t n = elites_.size();
    auto ticket = static_cast<std::uint64_t>(random_.uniform() * static_cast<double>(n * (n + 1) / 2));
    std::uint64_t rank = 0;
    for (; rank + 1 < n && ticket >= n - rank; ++rank) ticket -= n - rank;
    const RaceEntry& parent = entries_[elites_[rank]];
    return {drawn_near(parameters_, parent.candidate, parent.near, random_), parent.near, true, {}};
}

std::uint64_t Race::missing_trials(const std::vector<std::size_t>& alive, std::uint64_t seed) const {
    return static_cast<std::uint64_t>(std::ranges::count_if(alive, [&](std::size_t candidate) {
        const auto& costs = entries_[candidate].costs;
        return seed >= costs.size() || !costs[seed];
    }));
}

/// Runs the trials that have not run yet.
void Race::run_missing_trials(const std::vector<std::size_t>& alive, const std::vector<std::uint64_t>& seeds) {
    std::vector<RaceTrial> trials;
    for (const std::uint64_t seed : seeds) {
        seeds_ = std::max(seeds_, seed + 1);
        for (const std::size_t candidate : alive) {
            entries_[candidate].costs.resize(std::max<std::size_t>(entries_[candidate].costs.size(), seed + 1));
            if (!entries_[candidate].costs[seed]) trials.push_back({candidate, seed});
        }
    }
    const std::vector<double> costs = subject_.trial_costs(trials);
    for (std::size_t t = 0; t < trials.size(); ++t) entries_[trials[t].candidate].costs[trials[t].seed] = costs.at(t);
    trials_ += trials.size();
    iterations_.back().trials += trials.size();
}

/// Runs the race of one iteration, within its share of the budget. The first seed is new, so that elites and other
/// candidates are tested on it in the same way. The seeds on which elites have run come next, and then further new
/// seeds.
void Race::run_competition(std::vector<std::size_t> alive, std::uint64_t share) {
    const std::uint64_t known = elites_.empty() ? 0 : seeds_;
    const std::uint64_t begin = trials_;
    std::vector<std::uint64_t> done;
    const auto seed_at = [&](std::uint64_t place) {
        if (known == 0 || place > known) return place;
        return place == 0 ? known : place - 1;
    };
    while (true) {
        const std::uint64_t step = done.empty() ? first_test : 1;
        std::vector<std::uint64_t> next;
        std::uint64_t trials = 0;
        for (std::uint64_t i = 0; i < step; ++i) {
            next.push_back(seed_at(done.size() + i));
            trials += missing_trials(alive, next.back());
        }
        if (trials_ - begin + trials > share) break;
        run_missing_trials(alive, next);
        done.insert(done.end(), next.begin(), next.end());
        if (!find_admitted_leader(alive, done)) break;
        const std::vector<std::size_t> remaining = not_worse(alive, done);
        std::erase_if(alive, [&](std::size_t candidate) {
            const bool elite = std::ranges::find(elites_, candidate) != elites_.end();
            const bool shielded = elite && done.size() <= known;
            return !shielded && std::ranges::find(remaining, candidate) == remaining.end();
        });
        if (alive.size() <= survivor_count()) break;
    }
    iterations_.back().seeds = done.size();
    iterations_.back().left = alive.size();
    if (alive.empty())
        elites_.clear();
    else if (!done.empty())
        choose_elites(rank_candidates(std::move(alive), done));
}

std::vector<std::size_t> Race::rank_candidates(std::vector<std::size_t> alive,
                                               const std::vector<std::uint64_t>& seeds) const {
    const std::vector<statistics::Block> blocks = blocks_of(entries_, alive, seeds);
    const std::vector<double> by_rank = sum_by_candidate(blocks, options_.elimination == Elimination::friedman);
    const std::vector<double> by_cost = sum_by_candidate(blocks, false);
    std::vector<std::size_t> order(alive.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return by_rank[a] != by_rank[b] ? by_rank[a] < by_rank[b] : by_cost[a] < by_cost[b];
    });
    std::vector<std::size_t> result;
    for (const std::size_t place : order) result.push_back(alive[place]);
    return result;
}

std::vector<std::size_t> Race::not_worse(const std::vector<std::size_t>& alive,
                                         const std::vector<std::uint64_t>& seeds) const {
    if (alive.size() < 2) return alive;
    const std::vector<statistics::Block> blocks = blocks_of(entries_, alive, seeds);
    const std::vector<bool> remains =
        options_.elimination == Elimination::friedman ? kept_by_ranks(blocks) : kept_by_means(blocks);
    std::vector<std::size_t> result;
    for (std::size_t c = 0; c < alive.size(); ++c)
        if (remains[c]) result.push_back(alive[c]);
    return result;
}

/// Removes candidates that rank higher than the best admitted one. This is needed because candidates are eliminated if
/// they are worse than the best, so the best one must be admitted. Returns false if no candidate is left.
bool Race::find_admitted_leader(std::vector<std::size_t>& alive, const std::vector<std::uint64_t>& seeds) {
    for (const std::size_t candidate : rank_candidates(alive, seeds)) {
        if (is_admitted(candidate)) return true;
        std::erase(alive, candidate);
    }
    return false;
}

bool Race::is_admitted(std::size_t candidate) {
    if (!admitted_.contains(candidate) && !refused_.contains(candidate)) {
        const bool good = subject_.admits_candidate(entries_[candidate].candidate);
        (good ? admitted_ : refused_).insert(candidate);
        if (!good) ++iterations_.back().refused;
    }
    return admitted_.contains(candidate);
}

/// Selects the best candidates that are admitted.
void Race::choose_elites(const std::vector<std::size_t>& best) {
    std::vector<std::size_t> chosen;
    for (const std::size_t candidate : best) {
        if (chosen.size() == survivor_count()) break;
        if (is_admitted(candidate)) chosen.push_back(candidate);
    }
    elites_ = std::move(chosen);
}

}  // namespace robochart::simulation
