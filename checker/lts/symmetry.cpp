// SPDX-License-Identifier: Apache-2.0
// Converts the state of each replica to a row of numbers. Equal numbers mean the same in all replicas of a set, so
// permuting replicas permutes their rows. The representative of a state is the image in which these rows are ascending.
#include "checker/lts/symmetry.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <span>
#include <stdexcept>

namespace robochart::lts {

Symmetry::Symmetry(std::vector<ReplicaSet> sets) : sets_(std::move(sets)) {
    const auto least = [&](Event event) {
        while (orbits_.contains(event) && orbits_[event] != event) event = orbits_[event];
        return event;
    };
    for (const ReplicaSet& set : sets_)
        for (const Replica& replica : set)
            for (const auto& [event, image] : replica.exchange) {
                const Event first = least(event);
                const Event second = least(image);
                orbits_[first] = orbits_[second] = std::min(first, second);
            }
    assert(std::ranges::all_of(sets_, [](const ReplicaSet& set) { return set.size() >= 2; }));
    for (auto& [event, into] : orbits_) into = least(event);
}

std::size_t Symmetry::replicas() const {
    std::size_t most = 0;
    for (const ReplicaSet& set : sets_) most = std::max(most, set.size());
    return most;
}

Event Symmetry::orbit_representative(Event event) const {
    const auto known = orbits_.find(event);
    return known == orbits_.end() ? event : known->second;
}

/// Reads the rows of a set's replicas, one after the other.
void Symmetry::read(const ReplicaSet& set, std::span<const std::uint32_t> state, Numbers& numbers) {
    numbers.clear();
    for (const Replica& replica : set)
        for (const ReplicaPart& part : replica.parts) numbers.push_back((*part.number)[part.field.get(state)]);
}

/// Writes a row to each replica. `places` says which row.
void Symmetry::write(const ReplicaSet& set, const Numbers& numbers, const std::vector<std::size_t>& places,
                     std::span<std::uint32_t> state) {
    for (std::size_t i = 0; i < set.size(); ++i) {
        assert(places[i] < set.size());
        std::size_t at = places[i] * set[i].parts.size();
        assert(at + set[i].parts.size() <= numbers.size());  // all replicas have equally many parts
        for (const ReplicaPart& part : set[i].parts) part.field.put(state, (*part.value)[numbers[at++]]);
    }
}

void Symmetry::replace_by_representative(std::span<std::uint32_t> state) {
    for (const ReplicaSet& set : sets_) {
        read(set, state, numbers_);
        const auto width = static_cast<std::ptrdiff_t>(set.front().parts.size());
        const auto less = [&](std::size_t a, std::size_t b) {
            const auto first = numbers_.begin() + static_cast<std::ptrdiff_t>(a) * width;
            const auto second = numbers_.begin() + static_cast<std::ptrdiff_t>(b) * width;
            return std::lexicographical_compare(first, first + width, second, second + width);
        };
        places_.resize(set.size());
        std::iota(places_.begin(), places_.end(), std::size_t{0});
        if (std::ranges::is_sorted(places_, less)) continue;
        std::ranges::stable_sort(places_, less);
        write(set, numbers_, places_, state);
    }
}

Symmetry::Permutation Symmetry::find_permutation(std::span<const std::uint32_t> from,
                                                 std::span<const std::uint32_t> to) const {
    Permutation result;
    assert(from.size() == to.size());
    Numbers before;
    Numbers after;
    for (const ReplicaSet& set : sets_) {
        read(set, from, before);
        read(set, to, after);
        const std::size_t width = set.front().parts.size();
        const auto same = [&](std::size_t a, std::size_t b) {
            const auto row = before.begin() + static_cast<std::ptrdiff_t>(a * width);
            return std::equal(row, row + static_cast<std::ptrdiff_t>(width),
                              after.begin() + static_cast<std::ptrdiff_t>(b * width));
        };
        std::vector<std::size_t>& places = result.emplace_back(set.size(), set.size());
        std::vector<bool> taken(set.size(), false);
        for (std::size_t i = 0; i < set.size(); ++i)
            if (same(i, i)) {
                places[i] = i;
                taken[i] = true;
            }
        for (std::size_t i = 0; i < set.size(); ++i)
            for (std::size_t j = 0; j < set.size() && places[i] == set.size(); ++j)
                if (!taken[j] && same(j, i)) {
                    places[i] = j;
                    taken[j] = true;
                }
        if (std::ranges::find(places, set.size()) != places.end())
            throw std::logic_error("no automorphism maps one of the states to the other");
    }
    return result;
}

void Symmetry::apply(const Permutation& permutation, std::span<std::uint32_t> state) const {
    assert(permutation.size() == sets_.size());
    Numbers numbers;
    for (std::size_t i = 0; i < sets_.size(); ++i) {
        read(sets_[i], state, numbers);
        write(sets_[i], numbers, permutation[i], state);
    }
}

}  // namespace robochart::lts
