// SPDX-License-Identifier: Apache-2.0
// A symmetry of a system permutes equal parts of its states and maps transitions to transitions (docs/search.md,
// "Symmetry"). This file finds the representative of a state under the symmetries of a system. Sources: Gibson-Robinson
// and Lowe, "Symmetry reduction in CSP model checking", STTT 2019; Clarke, Enders, Filkorn and Jha, "Exploiting
// symmetry in temporal logic model checking", FMSD 1996.
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "checker/lts/event.hpp"
#include "checker/lts/field.hpp"

namespace robochart::lts {

/// A permutation of events: the pairs (event, image) whose elements differ, in ascending order.
using EventPermutation = std::vector<std::pair<Event, Event>>;

/// A field of a replica: its position in a state, and the mapping between its values and common numbers, which mean the
/// same in every replica. So two replicas are in the same state if and only if all common numbers are equal.
struct ReplicaPart {
    Field field;
    std::shared_ptr<const std::vector<std::uint32_t>> number;  ///< value to common number
    std::shared_ptr<const std::vector<std::uint32_t>> value;   ///< common number to value
};

/// One of several parts of a system's states that can be exchanged.
struct Replica {
    std::vector<ReplicaPart> parts;  ///< part i corresponds to part i of the first replica
    EventPermutation exchange;       ///< the permutation of events if this replica and the first are exchanged
};

/// Two or more replicas. Any two of them can be exchanged.
using ReplicaSet = std::vector<Replica>;

/// A group of automorphisms: all permutations that keep each replica in its set. An automorphism maps a transition of a
/// state to a transition of the image state, with the image of the event. Tau and tick do not change.
class Symmetry {
public:
    /// For each set, a permutation p of its replicas: replica i gets the state of replica p[i].
    using Permutation = std::vector<std::vector<std::size_t>>;

    /// The sets must be disjoint.
    explicit Symmetry(std::vector<ReplicaSet> sets);

    [[nodiscard]] const std::vector<ReplicaSet>& sets() const { return sets_; }
    /// Returns the number of replicas in the largest set, or 0 if there are no sets.
    [[nodiscard]] std::size_t replicas() const;
    /// Returns the least image of `event` under the automorphisms. Two events have the same result if and only if one
    /// event is an image of the other event.
    [[nodiscard]] Event orbit_representative(Event event) const;
    /// Replaces a state by the representative of its images.
    void replace_by_representative(std::span<std::uint32_t> state);
    /// Returns an automorphism that maps `from` to `to`. Throws std::logic_error if the two states have different
    /// representatives.
    [[nodiscard]] Permutation find_permutation(std::span<const std::uint32_t> from,
                                               std::span<const std::uint32_t> to) const;
    /// Replaces a state by its image under the permutation.
    void apply(const Permutation& permutation, std::span<std::uint32_t> state) const;

private:
    using Numbers = std::vector<std::uint32_t>;
    static void read(const ReplicaSet& set, std::span<const std::uint32_t> state, Numbers& numbers);
    static void write(const ReplicaSet& set, const Numbers& numbers, const std::vector<std::size_t>& places,
                      std::span<std::uint32_t> state);

    std::vector<ReplicaSet> sets_;
    std::map<Event, Event> orbits_;
    Numbers numbers_;
    std::vector<std::size_t> places_;
};

}  // namespace robochart::lts
