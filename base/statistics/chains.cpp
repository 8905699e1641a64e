// SPDX-License-Identifier: Apache-2.0
#include "base/statistics/chains.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace robochart::statistics {

TransitionCounts::TransitionCounts(std::size_t states)
    : states_(states),
      counts_(states * states),
      looked_(states * states),
      visits_(states),
      looked_visits_(states),
      next_(states, looks_for_error(1).trials_of_next_look(0).value()) {}

void TransitionCounts::add(const StateSequence& sequence) {
    for (std::size_t at = 0; at + 1 < sequence.size(); ++at) {
        const std::size_t from = sequence[at];
        ++counts_.at(from * states_ + sequence[at + 1]);
        if (++visits_[from] < next_[from]) continue;
        const auto row = static_cast<std::ptrdiff_t>(from * states_);
        std::copy_n(counts_.begin() + row, states_, looked_.begin() + row);
        looked_visits_[from] = visits_[from];
        next_[from] = looks_for_error(1).trials_of_next_look(visits_[from]).value();
    }
}

Permitted all_permitted(std::size_t states) {
    return Permitted(states, std::vector<bool>(states, true));
}

namespace {

std::size_t permitted_of(const std::vector<bool>& row) {
    return static_cast<std::size_t>(std::ranges::count(row, true));
}

}  // namespace

std::vector<std::vector<Interval>> transition_intervals(const TransitionCounts& counts, const Permitted& permitted,
                                                        double error) {
    std::size_t open = 0;
    // Stores intervals by their counts, because many transitions have the same counts.
    std::map<std::pair<std::uint64_t, std::uint64_t>, Interval> known;
    for (const std::vector<bool>& row : permitted)
        if (permitted_of(row) > 1) open += permitted_of(row);
    const Looks looks = TransitionCounts::looks_for_error(error / static_cast<double>(std::max<std::size_t>(open, 1)));
    const auto interval = [&](std::uint64_t successes, std::uint64_t trials) {
        const auto [found, added] = known.try_emplace({successes, trials});
        if (added) found->second = looks.interval_after(successes, trials).value_or(Interval{0, 1});
        return found->second;
    };
    std::vector<std::vector<Interval>> result(counts.state_count(),
                                              std::vector<Interval>(counts.state_count(), Interval{0, 0}));
    for (std::size_t from = 0; from < counts.state_count(); ++from) {
        const std::size_t choices = permitted_of(permitted[from]);
        if (choices == 0) throw std::invalid_argument("no transition of a state is permitted");
        for (std::size_t to = 0; to < counts.state_count(); ++to) {
            if (!permitted[from][to]) {
                if (counts.count(from, to) > 0)
                    throw std::invalid_argument("a transition that is not permitted was seen");
                continue;
            }
            result[from][to] = choices == 1
                                   ? Interval{1, 1}
                                   : interval(counts.count_at_last_look(from, to), counts.count_at_last_look(from));
        }
    }
    return result;
}

namespace {

/// The visits of a state that follow visits of a given state. They are counted by next state, at present and at the
/// last look.
struct PairVisits {
    std::uint64_t visits = 0, looked_visits = 0;
    std::uint64_t next = TransitionCounts::looks_for_error(1).trials_of_next_look(0).value();
    std::map<std::size_t, std::uint64_t> counts, looked;

    void add(std::size_t to) {
        ++counts[to];
        if (++visits < next) return;
        looked = counts;
        looked_visits = visits;
        next = TransitionCounts::looks_for_error(1).trials_of_next_look(visits).value();
    }
};

/// Returns the states that had followed this state at the last look.
std::set<std::size_t> seen_next(const std::map<std::size_t, PairVisits>& befores) {
    std::set<std::size_t> result;
    for (const auto& [before, visits] : befores)
        for (const auto& [next, count] : visits.looked) result.insert(next);
    return result;
}

/// Caches intervals, because many pairs have the same counts.
class KnownIntervals {
public:
    explicit KnownIntervals(Looks looks) : looks_(looks) {}
    const Interval& interval_at(std::uint64_t successes, std::uint64_t visits) {
        const auto [found, added] = known_.try_emplace({successes, visits});
        if (added) found->second = looks_.interval_after(successes, visits).value();
        return found->second;
    }

private:
    Looks looks_;
    std::map<std::pair<std::uint64_t, std::uint64_t>, Interval> known_;
};

/// Compares the intervals for `next` of all states before `state`. If two intervals are disjoint, returns the two
/// states whose intervals are farthest apart.
OrderContradiction farthest_apart(std::size_t state, std::size_t next, const std::map<std::size_t, PairVisits>& befores,
                                  KnownIntervals& intervals) {
    OrderContradiction both{state, next, 0, 0, {0, 1}, {0, 1}};
    for (const auto& [before, visits] : befores) {
        if (visits.looked_visits == 0) continue;
        const auto seen = visits.looked.find(next);
        const Interval& here =
            intervals.interval_at(seen == visits.looked.end() ? 0 : seen->second, visits.looked_visits);
        if (here.high < both.after_less.high) both.less = before, both.after_less = here;
        if (here.low > both.after_more.low) both.more = before, both.after_more = here;
    }
    return both;
}

}  // namespace

double order_triples(const Permitted& permitted) {
    double count = 0;
    for (std::size_t state = 0; state < permitted.size(); ++state) {
        const std::size_t next = permitted_of(permitted[state]);
        std::size_t before = 0;
        for (const std::vector<bool>& row : permitted) before += row[state] ? 1U : 0U;
        if (next > 1) count += static_cast<double>(before) * static_cast<double>(next);
    }
    return std::max(count, 1.0);
}

std::optional<OrderContradiction> order_contradiction(const std::vector<StateSequence>& sequences,
                                                      const Permitted& permitted, double error,
                                                      diagnostics::Pollable& budget) {
    std::map<std::size_t, std::map<std::size_t, PairVisits>> pairs;  // by middle state and previous state
    for (const StateSequence& sequence : sequences)
        for (std::size_t at = 2; at < sequence.size(); ++at)
            pairs[sequence[at - 1]][sequence[at - 2]].add(sequence[at]);
    KnownIntervals intervals(TransitionCounts::looks_for_error(error / order_triples(permitted)));
    std::optional<OrderContradiction> worst;
    for (const auto& [state, befores] : pairs) {
        if (befores.size() < 2) continue;
        // No contradiction is possible in two cases. If only one next state is permitted, all intervals contain 1. If a
        // next state was never seen, all intervals contain 0.
        if (permitted_of(permitted[state]) < 2) continue;
        for (const std::size_t next : seen_next(befores)) {
            budget.poll();
            const OrderContradiction both = farthest_apart(state, next, befores, intervals);
            const double apart = both.after_more.low - both.after_less.high;
            if (apart > (worst ? worst->after_more.low - worst->after_less.high : 0)) worst = both;
        }
    }
    return worst;
}

bool contradicts_prediction(std::uint64_t successes, std::uint64_t trials, double error, const Interval& predicted) {
    const Interval seen = clopper_pearson(successes, trials, error);
    return seen.low > predicted.high || predicted.low > seen.high;
}

}  // namespace robochart::statistics
