#include "checker/markov/operators/robust.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "checker/markov/solve/arithmetic.hpp"

namespace robochart::markov {
namespace {

/// The branches in the order in which mass does most for the value.
std::vector<std::size_t> by_worth(const UncertainRow& row, const std::vector<double>& worth) {
    std::vector<std::size_t> order(row.branches.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return worth[row.branches[a].target] > worth[row.branches[b].target];
    });
    return order;
}

Interval point(double value) {
    return {value, value};
}
Interval smaller(const Interval& a, const Interval& b) {
    return {std::min(a.low(), b.low()), std::min(a.high, b.high)};
}
/// What is left of a mass; rounding does not make it negative.
Interval rest(const Interval& whole, const Interval& part) {
    const Interval left = whole - part;
    return {std::max(0.0, left.low()), std::max(0.0, left.high)};
}

/// The greatest expectation of `worth`, from above: every branch gets its least probability, and what is left goes to
/// the worthiest, each up to its greatest.
double within_bounds(const UncertainRow& row, const std::vector<double>& worth) {
    Interval sum = point(0);
    Interval left = point(1);
    for (const UncertainBranch& each : row.branches) {
        sum += point(each.low) * point(worth[each.target]);
        left = left - point(each.low);
    }
    if (left.high < 0) throw std::invalid_argument("the least probabilities of a state are more than 1 together");
    left = rest(left, point(0));
    for (const std::size_t at : by_worth(row, worth)) {
        const UncertainBranch& each = row.branches[at];
        const Interval more = smaller(left, point(each.high) - point(each.low));
        sum += more * point(worth[each.target]);
        left = rest(left, more);
    }
    if (left.low() > 0) throw std::invalid_argument("the greatest probabilities of a state are less than 1 together");
    return sum.high;
}

/// The same in the ball: up to half of the radius is moved to the worthiest branch, from the least worthy ones (Strehl
/// and Littman, JCSS 74, 2008).
double within_ball(const UncertainRow& row, const std::vector<double>& worth) {
    const std::vector<std::size_t> order = by_worth(row, worth);
    Interval sum = point(0);
    for (std::size_t at = 0; at < row.branches.size(); ++at)
        sum += point(row.centre[at]) * point(worth[row.branches[at].target]);
    const double best = worth[row.branches[order.front()].target];
    Interval moved = smaller(point(row.radius / 2), rest(point(1), point(row.centre[order.front()])));
    for (std::size_t k = order.size(); k-- > 1;) {
        const std::size_t at = order[k];
        const Interval taken = smaller(moved, point(row.centre[at]));
        sum += taken * (point(best) - point(worth[row.branches[at].target]));
        moved = rest(moved, taken);
    }
    return sum.high;
}

double expectation(const UncertainRow& row, const std::vector<double>& worth) {
    if (row.branches.empty()) throw std::invalid_argument("a state leads nowhere");
    return row.centre.empty() ? within_bounds(row, worth) : within_ball(row, worth);
}

}  // namespace

std::vector<std::vector<double>> reach_bounds(const UncertainChain& chain, const StateSet& goal, std::uint64_t steps,
                                              Direction direction, diagnostics::Budget* budget) {
    const RoundUpward rounding;
    // A lower bound of a minimum is the negative of an upper bound of the maximum of negative worths.
    const double there = direction == Direction::maximum ? 1 : -1;
    const auto value = [&](double worth) { return std::clamp(there * worth, 0.0, 1.0); };
    std::vector<double> worth(chain.size());
    for (std::size_t state = 0; state < chain.size(); ++state) worth[state] = goal[state] ? there : 0;
    std::vector<std::vector<double>> result;
    const auto note = [&] {
        std::vector<double>& bounds = result.emplace_back();
        for (const double each : worth) bounds.push_back(value(each));
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

}  // namespace robochart::markov
