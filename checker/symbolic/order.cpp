// SPDX-License-Identifier: Apache-2.0
#include "checker/symbolic/order.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/diagnostics/containers.hpp"

namespace robochart::symbolic {
namespace {

using Indices = std::vector<std::uint32_t>;

class Ordering {
public:
    Ordering(const std::vector<std::uint32_t>& domains, const std::vector<Indices>& groups,
             diagnostics::Pollable& budget)
        : size_(domains.size()), budget_(budget) {
        for (const std::uint32_t domain : domains) weight_.push_back(std::log2(static_cast<double>(domain) + 1));
        // A group that contains a large part of the variables spans many levels in every order, so it is ignored.
        const std::size_t most = std::max<std::size_t>(8, size_ / 3);
        for (const Indices& group : groups)
            if (group.size() > 1 && group.size() <= most) groups_.push_back(group);
        diagnostics::sort_unique(groups_);
    }

    Indices best() const {
        Indices given(size_);
        std::iota(given.begin(), given.end(), 0U);
        const Indices breadth_first = order_breadth_first();
        Indices best = given;
        for (const Indices& order : {force(given), breadth_first, force(breadth_first)})
            if (cost(order) < cost(best)) best = order;
        return best;
    }

private:
    static Indices places_of(const Indices& order) {
        Indices places(order.size());
        for (std::uint32_t place = 0; place < order.size(); ++place) places[order[place]] = place;
        return places;
    }

    /// Returns the cost of an order. For each group, it is the sum of the bits of all variables from the first to the
    /// last variable of the group. The costs of all groups are added.
    double cost(const Indices& order) const {
        const Indices places = places_of(order);
        std::vector<double> before{0};
        for (const std::uint32_t variable : order) before.push_back(before.back() + weight_[variable]);
        double sum = 0;
        for (const Indices& group : groups_) {
            budget_.poll();
            const auto by_place = [&](std::uint32_t a, std::uint32_t b) { return places[a] < places[b]; };
            const auto [first, last] = std::ranges::minmax_element(group, by_place);
            sum += before[places[*last] + std::size_t{1}] - before[places[*first]];
        }
        return sum;
    }

    /// Improves an order by FORCE: each round moves every variable to the mean of the centres of its groups. The
    /// function ends when several rounds have not reduced the cost.
    Indices force(Indices order) const {
        constexpr int most_rounds = 100, rounds_without_gain = 5;
        Indices best = order;
        double best_cost = cost(order);
        for (int round = 0, idle = 0; round < most_rounds && idle < rounds_without_gain; ++round) {
            const Indices places = places_of(order);
            std::vector<double> sums(size_), counts(size_);
            for (const Indices& group : groups_) {
                budget_.poll();
                double centre = 0;
                for (const std::uint32_t variable : group) centre += places[variable];
                centre /= static_cast<double>(group.size());
                for (const std::uint32_t variable : group) {
                    sums[variable] += centre;
                    ++counts[variable];
                }
            }
            for (std::size_t variable = 0; variable < size_; ++variable)
                sums[variable] = counts[variable] > 0 ? sums[variable] / counts[variable] : places[variable];
            std::ranges::stable_sort(order, {}, [&](std::uint32_t variable) { return sums[variable]; });
            const double now = cost(order);
            ++idle;
            if (now >= best_cost) continue;
            best = order;
            best_cost = now;
            idle = 0;
        }
        return best;
    }

    Indices order_breadth_first() const {
        std::vector<Indices> neighbours(size_);
        for (const Indices& group : groups_)
            for (const std::uint32_t a : group) {
                budget_.poll();
                for (const std::uint32_t b : group)
                    if (a != b) neighbours[a].push_back(b);
            }
        for (Indices& list : neighbours) diagnostics::sort_unique(list);
        for (Indices& list : neighbours)
            std::ranges::stable_sort(list, {}, [&](std::uint32_t variable) { return neighbours[variable].size(); });
        Indices order;
        std::vector<bool> placed(size_);
        for (std::uint32_t start = 0; start < size_; ++start) {
            if (placed[start]) continue;
            // The traversal should start at the border of the graph, because its levels are then narrow. The last
            // variable of a traversal is at the border.
            std::uint32_t end = start;
            for (int again = 0; again < 2; ++again) end = traverse(end, neighbours).back();
            for (const std::uint32_t variable : traverse(end, neighbours)) {
                placed[variable] = true;
                order.push_back(variable);
            }
        }
        return order;
    }

    Indices traverse(std::uint32_t start, const std::vector<Indices>& neighbours) const {
        Indices reached{start};
        std::vector<bool> found(size_);
        found[start] = true;
        for (std::size_t at = 0; at < reached.size(); ++at) {
            budget_.poll();
            for (const std::uint32_t next : neighbours[reached[at]])
                if (!found[next]) {
                    found[next] = true;
                    reached.push_back(next);
                }
        }
        return reached;
    }

    std::size_t size_;
    diagnostics::Pollable& budget_;
    std::vector<double> weight_;
    std::vector<Indices> groups_;
};

}  // namespace

std::vector<std::uint32_t> order_variables(const std::vector<std::uint32_t>& domains,
                                           const std::vector<std::vector<std::uint32_t>>& groups,
                                           diagnostics::Pollable& budget) {
    return Ordering(domains, groups, budget).best();
}

}  // namespace robochart::symbolic
