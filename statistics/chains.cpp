#include "statistics/chains.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace robochart::statistics {

void TransitionCounts::add(const StateSequence& sequence) {
    std::vector<bool> visited(states_);
    for (std::size_t at = 0; at + 1 < sequence.size(); ++at) {
        const std::size_t from = sequence[at];
        if (visited.at(from)) continue;
        visited[from] = true;
        ++counts_.at(from * states_ + sequence[at + 1]);
    }
}

std::uint64_t TransitionCounts::visits(std::size_t from) const {
    const auto row = counts_.begin() + static_cast<std::ptrdiff_t>(from * states_);
    return std::accumulate(row, row + static_cast<std::ptrdiff_t>(states_), std::uint64_t{0});
}

Permitted all_permitted(std::size_t states) {
    return Permitted(states, std::vector<bool>(states, true));
}

namespace {

std::size_t permitted_of(const std::vector<bool>& row) {
    return static_cast<std::size_t>(std::count(row.begin(), row.end(), true));
}

}  // namespace

std::vector<std::vector<Interval>> transition_intervals(const TransitionCounts& counts, const Permitted& permitted,
                                                        double error) {
    std::size_t open = 0;
    for (const std::vector<bool>& row : permitted)
        if (permitted_of(row) > 1) open += permitted_of(row);
    std::vector<std::vector<Interval>> result(counts.states(), std::vector<Interval>(counts.states(), Interval{0, 0}));
    for (std::size_t from = 0; from < counts.states(); ++from) {
        const std::size_t choices = permitted_of(permitted[from]);
        if (choices == 0) throw std::invalid_argument("no transition of a state is permitted");
        for (std::size_t to = 0; to < counts.states(); ++to) {
            if (!permitted[from][to]) {
                if (counts.count(from, to) > 0)
                    throw std::invalid_argument("a transition that is not permitted was seen");
                continue;
            }
            result[from][to] = choices == 1 ? Interval{1, 1}
                                            : clopper_pearson(counts.count(from, to), counts.visits(from),
                                                              error / static_cast<double>(open));
        }
    }
    return result;
}

double weissman_radius(std::size_t values, std::uint64_t draws, double error) {
    if (values < 2) return 0;
    if (draws == 0) return 2;
    const auto count = static_cast<double>(values);
    // ln(2^values - 2), also where 2^values is no double.
    const double sets = values > 60 ? count * std::log(2.0) : std::log(std::exp2(count) - 2);
    const double radius = std::sqrt(2 * (sets - std::log(error)) / static_cast<double>(draws));
    return std::min(2.0, radius * (1 + 1e-12));
}

bool contradicts(std::uint64_t successes, std::uint64_t trials, double error, const Interval& predicted) {
    const Interval seen = clopper_pearson(successes, trials, error);
    return seen.low > predicted.high || predicted.low > seen.high;
}

}  // namespace robochart::statistics
