// SPDX-License-Identifier: Apache-2.0
// Represents conditions of a swarm's claims as events that observe all robots at once.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "csp_emit/swarm/swarm.hpp"

namespace robochart::csp_emit {

/// An event with the data on which a condition depends. It has a field for each different atom of the condition. For
/// `linked` and `apart`, the field is the set of pairs within the distance. For `away`, it states whether robot 0 is
/// away.
class Observation {
public:
    /// `channel` is the name of the event's channel.
    Observation(const SwarmCondition& condition, std::string channel);

    [[nodiscard]] const std::string& channel() const { return channel_; }
    /// True if the condition has an atom of this kind.
    [[nodiscard]] bool has_atom(SwarmCondition::Kind kind) const;
    /// True if the condition has an atom about pairs of robots.
    [[nodiscard]] bool asks_pairs() const;
    [[nodiscard]] std::string channel_declaration() const;
    /// Returns the event in which the pair i__, j__ at offset x__, y__ takes part.
    [[nodiscard]] std::string seen_by_pair() const;
    /// Returns the event while robot 0, which began at x, y, is at x__, y__.
    [[nodiscard]] std::string seen_on_way(std::int64_t x, std::int64_t y) const;
    /// Returns the definitions of `holds_CHANNEL` and `fails_CHANNEL`: the events for which the condition holds, and
    /// those for which it fails.
    [[nodiscard]] std::string define_meaning() const;

private:
    /// An atom: a part of a condition that has no parts itself.
    struct Atom {
        SwarmCondition::Kind kind;
        std::uint32_t distance;
    };

    void collect_atoms(const SwarmCondition& condition);
    [[nodiscard]] std::string condition_text(const SwarmCondition& condition) const;
    [[nodiscard]] std::string chain_text(std::span<const SwarmCondition> parts, const char* word) const;
    [[nodiscard]] std::size_t atom_index(const SwarmCondition& condition) const;

    std::string channel_;
    SwarmCondition condition_;
    std::vector<Atom> atoms_;
};

}  // namespace robochart::csp_emit
