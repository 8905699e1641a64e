// Symmetries of a system: exchanges of equal parts of its states that map transitions to transitions (docs/search.md,
// "Symmetry"). Gibson-Robinson and Lowe, "Symmetry reduction in CSP model checking", STTT 2019; Clarke, Enders, Filkorn
// and Jha, "Exploiting symmetry in temporal logic model checking", FMSD 1996.
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "checker/lts/event.hpp"
#include "checker/lts/field.hpp"

namespace robochart::lts {

/// A permutation of events: its pairs (event, image) where the two differ, ascending.
using EventPermutation = std::vector<std::pair<Event, Event>>;

/// A value of a state that belongs to a replica, and how it reads in common numbers: replicas are in the same state
/// where these numbers are equal.
struct ReplicaPart {
    Field field;
    std::shared_ptr<const std::vector<std::uint32_t>> number;  ///< by value, the common number
    std::shared_ptr<const std::vector<std::uint32_t>> value;   ///< by common number, the value
};

/// One of several equal parts of a system's states.
struct Replica {
    std::vector<ReplicaPart> parts;  ///< the first replica's parts and this one's correspond, in this order
    EventPermutation exchange;       ///< the events that are exchanged where the first replica and this one are
};

/// Replicas of which each can be exchanged with the first, and so any two. At least two.
using ReplicaSet = std::vector<Replica>;

/// A group of automorphisms: all permutations of replicas inside their sets. An automorphism maps each transition of a
/// state to one of the state's image, by the event's image; tau and tick are their own images.
class Symmetry {
public:
    /// Of each set, whose place each replica takes: replica i gets the state of replica `[i]`.
    using Permutation = std::vector<std::vector<std::size_t>>;

    /// The sets have no part in common.
    explicit Symmetry(std::vector<ReplicaSet> sets);

    [[nodiscard]] const std::vector<ReplicaSet>& sets() const { return sets_; }
    /// The number of replicas in the largest set; 0 without any.
    [[nodiscard]] std::size_t replicas() const;
    /// The least event that automorphisms map the event to: the same for two events iff one maps one to the other.
    [[nodiscard]] Event orbit(Event event) const;
    /// Replaces a state by the one that stands for all its images.
    void fold(std::span<std::uint32_t> state);
    /// An automorphism that maps one state to the other. They have the same representative; throws std::logic_error
    /// otherwise.
    [[nodiscard]] Permutation between(std::span<const std::uint32_t> from, std::span<const std::uint32_t> to) const;
    /// Replaces a state by its image.
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
