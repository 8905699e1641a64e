// SPDX-License-Identifier: Apache-2.0
// See probable_paths.hpp. A path costs the sum of -log of its probabilities. Dijkstra's algorithm, backwards from the
// goal, gives every state its cheapest path to the goal. So the cheapest path with a given prefix is the prefix
// followed by the cheapest path from its last state. Every other path with this prefix deviates at some state, which
// gives a longer prefix. The prefixes are in a queue, ordered by the cost of their cheapest paths (Lawler, A procedure
// for computing the K best solutions to discrete optimization problems, Management Science 18, 1972).
#include "prism/markov/paths/probable_paths.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "prism/markov/solve/interval.hpp"

namespace robochart::markov {
namespace {

constexpr State nowhere = ~State{0};
/// The maximal number of stored prefixes.
constexpr std::size_t most_beginnings = 5'000'000;

class Search {
public:
    explicit Search(const PathsWanted& request)
        : request_(request),
          model_(request.graph.model()),
          cost_(model_.states(), infinity),
          toward_(model_.states(), nowhere) {}

    PathSet operator()() {
        measure_distances();
        PathSet result;
        Interval total;
        if (cost_[request_.from] == infinity) return result;
        push(request_.from, none, 0, 0);
        const RoundUpward rounding;
        while (!queue_.empty() && result.paths.size() < request_.most && beginnings_.size() < most_beginnings) {
            const std::optional<Path> path = extend_to_target(queue_.top().second);
            if (!path) continue;
            result.paths.push_back(*path);
            total += Interval(path->probability.low, path->probability.high);
            result.total = total.enclosure();
            result.enough = request_.strict ? result.total.low > request_.bound : result.total.low >= request_.bound;
            if (result.enough || out_of_reach(result)) break;
        }
        return result;
    }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    struct Beginning {
        State state;
        std::uint32_t before;  ///< the prefix that ends one state earlier
        std::uint32_t steps;
        double cost;
    };
    using Entry = std::pair<double, std::uint32_t>;

    /// Returns whether the bound cannot be reached, because the remaining paths are less probable than the last one.
    [[nodiscard]] bool out_of_reach(const PathSet& found) const {
        const auto left = static_cast<double>(request_.most - found.paths.size());
        return left * found.paths.back().probability.high < request_.bound - found.total.low;
    }

    [[nodiscard]] Number branch_probability(std::uint64_t branch) const {
        return model_.numbers[model_.number[branch]];
    }
    [[nodiscard]] double branch_cost(std::uint64_t branch) const {
        return -std::log(std::min(1.0, branch_probability(branch).high));
    }

    void poll() const {
        if (request_.budget != nullptr) request_.budget->poll();
    }

    /// Returns the branch of the strategy's choice that leads to a state.
    [[nodiscard]] std::uint64_t branch(State state, State to) const {
        const std::uint32_t choice = request_.strategy[state];
        const std::span<const State> all = targets(model_, choice);
        return model_.first_branch[choice] +
               static_cast<std::uint64_t>(std::ranges::lower_bound(all, to) - all.begin());
    }

    void measure_distances() {
        std::priority_queue<std::pair<double, State>, std::vector<std::pair<double, State>>, std::greater<>> queue;
        for (State state = 0; state < model_.states(); ++state)
            if (request_.right[state]) {
                cost_[state] = 0;
                queue.emplace(0, state);
            }
        while (!queue.empty()) {
            poll();
            const auto [known, state] = queue.top();
            queue.pop();
            if (known > cost_[state]) continue;
            for (const std::uint32_t choice : request_.graph.choices_to(state)) {
                const State source = request_.graph.source(choice);
                if (request_.strategy[source] != choice || !request_.left[source] || request_.right[source]) continue;
                const double found = known + branch_cost(branch(source, state));
                if (!(found < cost_[source])) continue;
                cost_[source] = found;
                toward_[source] = state;
                queue.emplace(found, source);
            }
        }
    }

    std::uint32_t push(State state, std::uint32_t before, std::uint32_t steps, double cost) {
        beginnings_.push_back({state, before, steps, cost});
        const auto number = static_cast<std::uint32_t>(beginnings_.size() - 1);
        queue_.emplace(cost + cost_[state], number);
        return number;
    }

    /// Returns the cheapest path with this prefix. Stores the prefixes that deviate from it. No value if the path is
    /// too long.
    std::optional<Path> extend_to_target(std::uint32_t number) {
        queue_.pop();
        while (!request_.right[beginnings_[number].state]) {
            poll();
            const Beginning at = beginnings_[number];
            if (request_.steps && at.steps >= *request_.steps) return std::nullopt;
            const std::uint32_t choice = request_.strategy[at.state];
            for (std::uint64_t i = model_.first_branch[choice]; i < model_.first_branch[choice + 1]; ++i) {
                const State to = model_.target[i];
                if (to != toward_[at.state] && cost_[to] < infinity)
                    push(to, number, at.steps + 1, at.cost + branch_cost(i));
            }
            const State next = toward_[at.state];
            beginnings_.push_back({next, number, at.steps + 1, at.cost + branch_cost(branch(at.state, next))});
            number = static_cast<std::uint32_t>(beginnings_.size() - 1);
        }
        return path_to(number);
    }

    [[nodiscard]] Path path_to(std::uint32_t number) const {
        Path result;
        for (; number != none; number = beginnings_[number].before) result.states.push_back(beginnings_[number].state);
        std::ranges::reverse(result.states);
        Interval probability(1, 1);
        for (std::size_t i = 0; i + 1 < result.states.size(); ++i) {
            const Number factor = this->branch_probability(branch(result.states[i], result.states[i + 1]));
            probability = Interval(factor.low, factor.high) * probability;
        }
        result.probability = probability.enclosure();
        return result;
    }

    const PathsWanted& request_;
    const Model& model_;
    std::vector<double> cost_;  ///< for each state, the cost of the cheapest path to the goal
    std::vector<State> toward_;
    std::vector<Beginning> beginnings_;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

PathSet probable_paths(const PathsWanted& request) {
    return Search(request)();
}

}  // namespace robochart::markov
