// SPDX-License-Identifier: Apache-2.0
// See isotonic.hpp.
#include "frontend/diagrams/layout/isotonic.hpp"

#include <algorithm>
#include <cstddef>

namespace robochart::diagrams::layout {
namespace {

/// Adjacent items at one position, after subtracting the gaps.
struct Pool {
    double mean = 0, weight = 0;
    std::size_t count = 0;
};

void add(std::vector<Pool>& pools, Pool pool) {
    while (!pools.empty() && pools.back().mean >= pool.mean) {
        const Pool& other = pools.back();
        const double weight = pool.weight + other.weight;
        pool = {(pool.mean * pool.weight + other.mean * other.weight) / weight, weight, pool.count + other.count};
        pools.pop_back();
    }
    pools.push_back(pool);
}

double extent(std::span<const Wish> wishes) {
    double sum = 0;
    for (std::size_t i = 1; i < wishes.size(); ++i) sum += wishes[i].gap;
    return sum;
}

}  // namespace

std::vector<double> nearest_places(std::span<const Wish> wishes) {
    std::vector<Pool> pools;
    double offset = 0;
    for (std::size_t i = 0; i < wishes.size(); ++i) {
        if (i > 0) offset += wishes[i].gap;
        add(pools, {wishes[i].wanted - offset, wishes[i].weight, 1});
    }
    std::vector<double> places;
    offset = 0;
    for (const Pool& pool : pools)
        for (std::size_t i = 0; i < pool.count; ++i) {
            if (!places.empty()) offset += wishes[places.size()].gap;
            places.push_back(pool.mean + offset);
        }
    return places;
}

std::vector<double> nearest_places(std::span<const Wish> wishes, double low, double high) {
    const double needed = extent(wishes);
    std::vector<double> places = nearest_places(wishes);
    if (needed > high - low) {
        const double step = wishes.size() > 1 ? (high - low) / static_cast<double>(wishes.size() - 1) : 0;
        for (std::size_t i = 0; i < places.size(); ++i) places[i] = low + step * static_cast<double>(i);
        return places;
    }
    double before = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (i > 0) before += wishes[i].gap;
        places[i] = std::clamp(places[i], low + before, high - (needed - before));
    }
    return places;
}

}  // namespace robochart::diagrams::layout
