// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/operators/robust.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "prism/markov/solve/arithmetic.hpp"

namespace robochart::markov {
namespace {

/// Returns the branches, sorted by the worth of their targets, best first.
std::vector<std::size_t> by_worth(const UncertainRow& row, const std::vector<double>& worth) {
    std::vector<std::size_t> order(row.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order,
                             [&](std::size_t a, std::size_t b) { return worth[row[a].target] > worth[row[b].target]; });
    return order;
}

Interval point(double value) {
    return {value, value};
}
Interval lesser_bounds(const Interval& a, const Interval& b) {
    return {std::min(a.low(), b.low()), std::min(a.high, b.high)};
}
/// Subtracts a part from a probability mass. The result is not negative in spite of rounding.
Interval remaining_mass(const Interval& whole, const Interval& part) {
    const Interval left = whole - part;
    return {std::max(0.0, left.low()), std::max(0.0, left.high)};
}

/// Returns an upper bound on the greatest expectation of `worth`: every branch gets its least probability, and the rest
/// is assigned to the best branches, each up to its greatest probability.
double expectation(const UncertainRow& row, const std::vector<double>& worth) {
    if (row.empty()) throw std::invalid_argument("a state leads nowhere");
    Interval sum = point(0);
    Interval left = point(1);
    for (const UncertainBranch& branch : row) {
        sum += point(branch.low) * point(worth[branch.target]);
        left = left - point(branch.low);
    }
    if (left.high < 0) throw std::invalid_argument("the least probabilities of a state are more than 1 together");
    left = remaining_mass(left, point(0));
    for (const std::size_t at : by_worth(row, worth)) {
        const UncertainBranch& branch = row[at];
        const Interval more = lesser_bounds(left, point(branch.high) - point(branch.low));
        sum += more * point(worth[branch.target]);
        left = remaining_mass(left, more);
    }
    if (left.low() > 0) throw std::invalid_argument("the greatest probabilities of a state are less than 1 together");
    return sum.high;
}

/// Returns the sign of the worths. A lower bound of a minimum is the negative of an upper bound of the maximum of the
/// negated worths.
double sign_of(Direction direction) {
    return direction == Direction::maximum ? 1 : -1;
}

/// Returns the states outside `goal` in which nature can keep the chain forever: the greatest set that nature need not
/// leave. If rounding prevents a decision, the result may be larger.
StateSet states_kept_forever(const UncertainChain& chain, const StateSet& goal, diagnostics::Budget* budget) {
    std::vector<double> inside(chain.size());
    for (std::size_t state = 0; state < chain.size(); ++state) inside[state] = goal[state] ? 0 : 1;
    for (bool changed = true; changed;) {
        poll(budget);
        changed = false;
        for (std::size_t state = 0; state < chain.size(); ++state)
            if (inside[state] > 0 && expectation(chain[state], inside) < 1) {
                inside[state] = 0;
                changed = true;
            }
    }
    StateSet result;
    for (const double indicator : inside) result.push_back(indicator > 0);
    return result;
}

/// Returns the states outside `goal` from which nature can bring the chain into `target` with positive probability.
StateSet leading_to(const UncertainChain& chain, const StateSet& goal, StateSet target, diagnostics::Budget* budget) {
    std::vector<double> there(target.begin(), target.end());
    for (bool changed = true; changed;) {
        poll(budget);
        changed = false;
        for (std::size_t state = 0; state < chain.size(); ++state)
            if (!goal[state] && !target[state] && expectation(chain[state], there) > 0) {
                target[state] = true;
                there[state] = 1;
                changed = true;
            }
    }
    return target;
}

/// Returns upper bounds on the costs from each state, computed from bounds for its successors; 0 for the states in
/// `done`.
std::vector<double> costs_behind(const UncertainChain& chain, const StateSet& done, const std::vector<double>& cost,
                                 const std::vector<double>& worth, double sign) {
    std::vector<double> next(chain.size());
    for (std::size_t state = 0; state < chain.size(); ++state)
        if (!done[state]) next[state] = sign * cost[state] + expectation(chain[state], worth);
    return next;
}

double greatest_change(const std::vector<double>& before, const std::vector<double>& now) {
    double most = 0;
    for (std::size_t state = 0; state < now.size(); ++state)
        most = std::max(most, std::abs(now[state] - before[state]) / std::max(1e-300, std::abs(now[state])));
    return most;
}

/// Returns a vector w with w >= costs + expectation of w over successors, near the result of value iteration. Returns
/// an empty vector if none is found.
std::vector<double> inductive(const UncertainChain& chain, const StateSet& done, const std::vector<double>& cost,
                              std::vector<double> worth) {
    constexpr double more = 1 + 1e-6;
    for (double& state_worth : worth) state_worth *= more;
    const std::vector<double> once = costs_behind(chain, done, cost, worth, 1);
    for (std::size_t state = 0; state < chain.size(); ++state)
        if (!done[state] && cost[state] == 0) worth[state] = once[state];
    const std::vector<double> behind = costs_behind(chain, done, cost, worth, 1);
    for (std::size_t state = 0; state < chain.size(); ++state)
        if (behind[state] > worth[state]) return {};
    return worth;
}

/// Returns the states that are reachable in some chain within the bounds.
StateSet reachable(const UncertainChain& chain, State from) {
    StateSet found(chain.size());
    std::vector<State> open{from};
    found[from] = true;
    while (!open.empty()) {
        const UncertainRow& row = chain[open.back()];
        open.pop_back();
        for (const UncertainBranch& branch : row)
            if (branch.high > 0 && !found[branch.target]) {
                found[branch.target] = true;
                open.push_back(branch.target);
            }
    }
    return found;
}

}  // namespace

std::vector<std::vector<double>> reach_bounds(const UncertainChain& chain, const StateSet& goal, std::uint64_t steps,
                                              Direction direction, diagnostics::Budget* budget) {
    const RoundUpward rounding;
    const double there = sign_of(direction);
    const auto value = [&](double worth) { return std::clamp(there * worth, 0.0, 1.0); };
    std::vector<double> worth(chain.size());
    for (std::size_t state = 0; state < chain.size(); ++state) worth[state] = goal[state] ? there : 0;
    std::vector<std::vector<double>> result;
    const auto note = [&] {
        std::vector<double>& bounds = result.emplace_back();
        for (const double state_worth : worth) bounds.push_back(value(state_worth));
    };
    note();
    for (std::uint64_t step = 0; step < steps; ++step) {
        poll(budget);
        std::vector<double> next(chain.size());
        for (std::size_t state = 0; state < chain.size(); ++state)
            next[state] = goal[state] ? there : expectation(chain[state], worth);
        worth = std::move(next);
        note();
    }
    return result;
}

std::vector<std::vector<double>> value_bounds(const UncertainChain& chain, const std::vector<double>& value,
                                              std::uint64_t steps, Direction direction, diagnostics::Budget* budget) {
    const RoundUpward rounding;
    const double sign = sign_of(direction);
    std::vector<double> worth;
    for (const double state_value : value) worth.push_back(sign * state_value);
    std::vector<std::vector<double>> result;
    for (std::uint64_t step = 0; step <= steps; ++step) {
        poll(budget);
        std::vector<double>& bounds = result.emplace_back();
        for (const double state_worth : worth) bounds.push_back(sign * state_worth);
        std::vector<double> next;
        for (const UncertainRow& row : chain) next.push_back(expectation(row, worth));
        worth = std::move(next);
    }
    return result;
}

std::vector<double> cost_bounds(const UncertainChain& chain, const StateSet& goal, const std::vector<double>& cost,
                                Direction direction, std::uint64_t most_rounds, diagnostics::Budget* budget) {
    constexpr double near = 1e-9;
    const RoundUpward rounding;
    const double sign = sign_of(direction);
    StateSet done = goal;
    StateSet infinite(chain.size());
    if (direction == Direction::maximum) {
        infinite = leading_to(chain, goal, states_kept_forever(chain, goal, budget), budget);
        for (std::size_t state = 0; state < chain.size(); ++state) done[state] = goal[state] || infinite[state];
    }
    std::vector<double> worth(chain.size());
    for (std::uint64_t round = 0; round < most_rounds; ++round) {
        poll(budget);
        std::vector<double> next = costs_behind(chain, done, cost, worth, sign);
        const bool settled = greatest_change(worth, next) < near;
        worth = std::move(next);
        if (settled) break;
    }
    constexpr double forever = std::numeric_limits<double>::infinity();
    if (direction == Direction::maximum) {
        worth = inductive(chain, done, cost, std::move(worth));
        if (worth.empty()) infinite.assign(chain.size(), true);
        worth.resize(chain.size());
    }
    for (std::size_t state = 0; state < chain.size(); ++state) {
        if (goal[state])
            worth[state] = 0;
        else
            worth[state] = infinite[state] ? forever : std::max(0.0, sign * worth[state]);
    }
    return worth;
}

double average_bound(const UncertainChain& chain, State from, const std::vector<double>& value, Direction direction,
                     std::uint64_t most_rounds, diagnostics::Budget* budget) {
    constexpr double near = 1e-9;
    const RoundUpward rounding;
    const double sign = sign_of(direction);
    const StateSet reached = reachable(chain, from);
    std::vector<double> worth(chain.size());
    double least = std::numeric_limits<double>::infinity();
    for (std::uint64_t round = 0; round < most_rounds; ++round) {
        poll(budget);
        double bound = -std::numeric_limits<double>::infinity();
        double other = std::numeric_limits<double>::infinity();
        std::vector<double> next(chain.size());
        for (std::size_t state = 0; state < chain.size(); ++state) {
            if (!reached[state]) continue;
            const double gain = sign * value[state] + expectation(chain[state], worth) - worth[state];
            bound = std::max(bound, gain);
            other = std::min(other, gain);
            next[state] = worth[state] + gain / 2;  // half a step, so that periodic chains converge too
        }
        least = std::min(least, bound);
        if (bound - other < near) break;
        const double shift = next[from];
        for (double& state_worth : next) state_worth -= shift;
        worth = std::move(next);
    }
    return sign * least;
}

}  // namespace robochart::markov
